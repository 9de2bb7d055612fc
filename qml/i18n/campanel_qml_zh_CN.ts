<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>AboutSection</name>
    <message>
        <source>CamPanel %1</source>
        <translation>CamPanel %1</translation>
    </message>
    <message>
        <source>Stop on this panel is not a safety function. The machine needs a hard-wired emergency stop.</source>
        <translation>本面板的“停止”不是安全功能。机器必须装有硬接线急停装置。</translation>
    </message>
    <message>
        <source>Touchscreen of an electronic-cam machine. CamPanel computes the cam, downloads the program to the motion controller and shows the controller&apos;s actual values.</source>
        <translation>电子凸轮机的触摸屏。CamPanel 计算凸轮，将程序下载到运动控制器，并显示控制器的实际值。</translation>
    </message>
    <message>
        <source>Licence: Apache 2.0. Made with Qt (LGPL 3), Qwt (Qwt licence 1.0), libmodbus (LGPL 2.1).</source>
        <translation>许可证：Apache 2.0。使用 Qt（LGPL 3）、Qwt（Qwt 许可证 1.0）和 libmodbus（LGPL 2.1）。</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Versions and disk</source>
        <translation>版本与磁盘</translation>
    </message>
    <message>
        <source>The disk is too small</source>
        <translation>磁盘空间太小</translation>
    </message>
    <message>
        <source>panel, gateway, controller, program</source>
        <translation>面板、网关、控制器、程序</translation>
    </message>
</context>
<context>
    <name>AlarmRow</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 次</translation>
    </message>
</context>
<context>
    <name>AlarmSheet</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>处理方法</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>发生</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消搁置</translation>
    </message>
    <message>
        <source>Shelve 1 h</source>
        <translation>搁置 1 小时</translation>
    </message>
    <message>
        <source>Shelve 8 h</source>
        <translation>搁置 8 小时</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
</context>
<context>
    <name>AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>未恢复</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Shelved: %1</source>
        <translation>搁置：%1</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>搁置</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>全部确认</translation>
    </message>
    <message>
        <source>No alarm is active or waiting for acknowledgment.</source>
        <translation>没有未恢复或待确认的报警。</translation>
    </message>
    <message>
        <source>Reading the log …</source>
        <translation>正在读取记录…</translation>
    </message>
    <message>
        <source>No alarm since the start of this log.</source>
        <translation>自记录开始以来尚无报警。</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>No alarm matches the filter.</source>
        <translation>没有符合筛选条件的报警。</translation>
    </message>
    <message>
        <source>Alarm number</source>
        <translation>报警编号</translation>
    </message>
    <message>
        <source>Alarms as CSV</source>
        <translation>报警导出为 CSV</translation>
    </message>
    <message>
        <source>Active, %1 new</source>
        <translation>未恢复，新 %1</translation>
    </message>
</context>
<context>
    <name>AuditRow</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>AuditSheet</name>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>All users</source>
        <translation>所有用户</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>There are no entries of this kind. Commands, downloads, parameters, settings and logins are recorded here.</source>
        <translation>没有此类记录。命令、下载、参数、设置和登录均记录在此。</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>返回列表</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>No entry matches the filter.</source>
        <translation>没有符合筛选条件的记录。</translation>
    </message>
    <message>
        <source>Audit trail as CSV</source>
        <translation>审计记录 CSV</translation>
    </message>
</context>
<context>
    <name>AxesSection</name>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
</context>
<context>
    <name>AxisSheet</name>
    <message>
        <source>Present setting</source>
        <translation>当前设置</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>As it should</source>
        <translation>方向正确</translation>
    </message>
    <message>
        <source>The other way</source>
        <translation>方向相反</translation>
    </message>
    <message>
        <source>Reverses the motor</source>
        <translation>使电机反向</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>保留原值</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Read ruler</source>
        <translation>读取直尺</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>输入……</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>One bag</source>
        <translation>单袋</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
</context>
<context>
    <name>BackupSection</name>
    <message>
        <source>Backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Create backup</source>
        <translation>生成备份</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Replaces all these data by a backup. The file is checked first, and the present data are saved as a backup.</source>
        <translation>用备份替换上述全部数据。先检查文件，并将当前数据保存为备份。</translation>
    </message>
    <message>
        <source>Choose file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>调试报告</translation>
    </message>
    <message>
        <source>PDF with the open recipe (curves, limits, table), machine data, controller program and last bags.</source>
        <translation>PDF 文件：当前配方（曲线、限值、数据表）、机器数据、控制器程序和最近的袋。</translation>
    </message>
    <message>
        <source>Create report</source>
        <translation>生成报告</translation>
    </message>
    <message>
        <source>Working …</source>
        <translation>正在处理…</translation>
    </message>
    <message>
        <source>Location of the backup</source>
        <translation>备份位置</translation>
    </message>
    <message>
        <source>Location of the report</source>
        <translation>报告位置</translation>
    </message>
    <message>
        <source>Restore this backup?</source>
        <translation>恢复此备份？</translation>
    </message>
    <message>
        <source>Service bundle</source>
        <translation>服务包</translation>
    </message>
    <message>
        <source>For the manufacturer&apos;s support: open recipe, table, controller, alarms and changes of 7 days, communication, the last 10 seconds. No PINs.</source>
        <translation>供制造商支持使用：当前配方、数据表、控制器、7 天的报警和更改、通信、最近 10 秒。不含 PIN。</translation>
    </message>
    <message>
        <source>Create bundle</source>
        <translation>生成服务包</translation>
    </message>
    <message>
        <source>Location of the service bundle</source>
        <translation>服务包位置</translation>
    </message>
    <message>
        <source>All data of this panel in one file: recipes with their versions, machine data, users, alarms, audit trail, bags, trends, settings.</source>
        <translation>本面板的全部数据合为一个文件：配方及其版本、机器数据、用户、报警、审计记录、袋记录、趋势、设置。</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Check and restore</source>
        <translation>检查并恢复</translation>
    </message>
    <message>
        <source>There is no backup on a USB stick or on this panel. Plug a stick in; the panel finds it automatically.</source>
        <translation>U 盘和本面板上都没有备份。请插入 U 盘，面板会自动找到。</translation>
    </message>
</context>
<context>
    <name>BagCard</name>
    <message>
        <source>Bag length</source>
        <translation>袋长</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>平均 %1</translation>
    </message>
    <message>
        <source>std dev %1</source>
        <translation>标准差 %1</translation>
    </message>
    <message>
        <source>tolerance ±%1</source>
        <translation>公差 ±%1</translation>
    </message>
    <message>
        <source>last %1</source>
        <translation>最近 %1</translation>
    </message>
    <message>
        <source>Scrap bag</source>
        <translation>废袋</translation>
    </message>
</context>
<context>
    <name>BagDrawing</name>
    <message>
        <source>Knife and bag, to scale</source>
        <translation>刀与袋（按比例）</translation>
    </message>
</context>
<context>
    <name>BannerHost</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>%1
And %2 more.</source>
        <translation>%1
另有 %2 条。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>查看</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>CamFilesSheet</name>
    <message>
        <source>There is no CSV file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.</source>
        <translation>U 盘和 %1 中都没有 CSV 文件。请插入 U 盘，面板会自动找到。</translation>
    </message>
    <message>
        <source>Choose the location of the new file.</source>
        <translation>请选择新文件的位置。</translation>
    </message>
    <message>
        <source>Choose a file to view its content.</source>
        <translation>请选择文件以查看其内容。</translation>
    </message>
    <message>
        <source>Segments as CSV</source>
        <translation>运动段 CSV 文件</translation>
    </message>
    <message>
        <source>Knots as CSV</source>
        <translation>型值点 CSV 文件</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>导入 CSV</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>导出 CSV</translation>
    </message>
    <message>
        <source>Write file</source>
        <translation>写入文件</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>正在写入…</translation>
    </message>
</context>
<context>
    <name>CamSheet</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
</context>
<context>
    <name>ChangePicture</name>
    <message>
        <source>The film keeps its speed.</source>
        <translation>薄膜速度不变。</translation>
    </message>
    <message>
        <source>down to %1 for %2</source>
        <translation>降至 %1，持续 %2</translation>
    </message>
</context>
<context>
    <name>ChangeSheet</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>减少</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>更改：%1</translation>
    </message>
    <message>
        <source>More</source>
        <translation>增加</translation>
    </message>
    <message>
        <source>Keypad</source>
        <translation>键盘</translation>
    </message>
    <message>
        <source>The machine runs with %1.</source>
        <translation>机器以 %1 运行。</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>取消下载</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Apply at the next bag</source>
        <translation>从下一袋起应用</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Give a reason …</source>
        <translation>说明原因 …</translation>
    </message>
</context>
<context>
    <name>CheckedBySheet</name>
    <message>
        <source>First bag checked by</source>
        <translation>首袋检查人</translation>
    </message>
</context>
<context>
    <name>CleaningMode</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Clean the screen now. The panel ignores touches until the time is over; Stop still works.</source>
        <translation>现在请清洁屏幕。计时结束前触摸无效，“停止”仍有效。</translation>
    </message>
</context>
<context>
    <name>ClockSheet</name>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>Time server</source>
        <translation>时间服务器</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>时区</translation>
    </message>
    <message>
        <source>− 1 d</source>
        <translation>− 1 天</translation>
    </message>
    <message>
        <source>+ 1 d</source>
        <translation>+ 1 天</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 小时</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 小时</translation>
    </message>
    <message>
        <source>− 10 min</source>
        <translation>− 10 分</translation>
    </message>
    <message>
        <source>+ 10 min</source>
        <translation>+ 10 分</translation>
    </message>
    <message>
        <source>− 1 min</source>
        <translation>− 1 分</translation>
    </message>
    <message>
        <source>+ 1 min</source>
        <translation>+ 1 分</translation>
    </message>
</context>
<context>
    <name>CodeSheet</name>
    <message>
        <source>Film reel of %1: scan the code or enter it</source>
        <translation>%1 的膜卷：扫描或输入条码</translation>
    </message>
    <message>
        <source>Code of %1: scan or enter it (empty: the name)</source>
        <translation>%1 的条码：扫描或输入；留空则用名称</translation>
    </message>
</context>
<context>
    <name>CodesSheet</name>
    <message>
        <source>Codes of %1</source>
        <translation>%1 的条码</translation>
    </message>
    <message>
        <source>Code that selects the recipe</source>
        <translation>选择配方的条码</translation>
    </message>
    <message>
        <source>Code of the film reel</source>
        <translation>膜卷条码</translation>
    </message>
</context>
<context>
    <name>CommandButton</name>
    <message>
        <source>hold longer</source>
        <translation>请按住更久</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>按住</translation>
    </message>
</context>
<context>
    <name>CommandColumn</name>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>again: immediate</source>
        <translation>再按：立即</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>没有连接</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>尚未发送</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>ConfirmSheet</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>ConnectionSection</name>
    <message>
        <source>None</source>
        <translation>无校验</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>偶校验</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>奇校验</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>请选择</translation>
    </message>
    <message>
        <source>Parity and stop bits</source>
        <translation>校验位和停止位</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>The simulated controller runs on this computer and moves no machine. It serves for training and for testing recipes.</source>
        <translation>仿真控制器在本机内运行，不会带动任何机器。用于培训和试验配方。</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
</context>
<context>
    <name>CurrentOrder</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>good %1 · rejected %2 · empty %3</source>
        <translation>合格 %1 · 剔除 %2 · 空袋 %3</translation>
    </message>
    <message>
        <source>First bag checked</source>
        <translation>首袋已检查</translation>
    </message>
    <message>
        <source>End order</source>
        <translation>结束订单</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>Velocity %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>Acceleration %1</source>
        <translation>加速度 %1</translation>
    </message>
    <message>
        <source>Jerk %1</source>
        <translation>跃度 %1</translation>
    </message>
    <message>
        <source>Pulse frequency kHz</source>
        <translation>脉冲频率 kHz</translation>
    </message>
    <message>
        <source>Motor torque Nm, RMS %1</source>
        <translation>电机转矩 Nm，均方根 %1</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>in the controller</source>
        <translation>在控制器中</translation>
    </message>
</context>
<context>
    <name>CutterInputs</name>
    <message>
        <source>Speed law</source>
        <translation>速度规律</translation>
    </message>
    <message>
        <source>View and tools</source>
        <translation>视图与工具</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>speeds, ratios, law</source>
        <translation>速度、比例、规律</translation>
    </message>
</context>
<context>
    <name>DialCard</name>
    <message>
        <source>Sync window</source>
        <translation>同步区</translation>
    </message>
</context>
<context>
    <name>DigitPad</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>DirectionCard</name>
    <message>
        <source>Master direction</source>
        <translation>主轴方向</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>正转</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>反转</translation>
    </message>
</context>
<context>
    <name>DisplaySection</name>
    <message>
        <source>tap</source>
        <translation>点按</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>Screen, clock, network</source>
        <translation>屏幕、时钟、网络</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Use light in a bright hall, dark in the night shift, high contrast for a dirty screen. Glove mode enlarges all keys by a quarter; numbers follow the language. Recipes and files stay metric.</source>
        <translation>明亮车间用浅色，夜班用深色，屏幕脏污时用高对比度。手套模式将所有按键放大四分之一；数字随语言而变。配方和文件保持公制。</translation>
    </message>
</context>
<context>
    <name>DoctorSection</name>
    <message>
        <source>Diagnose</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>for the controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>使用此</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>DownloadSheet</name>
    <message>
        <source>Download to the controller</source>
        <translation>下载到控制器</translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation>控制器中</translation>
    </message>
    <message>
        <source>On this panel</source>
        <translation>本面板</translation>
    </message>
    <message>
        <source>The controller has no program yet; this recipe becomes its first program.</source>
        <translation>控制器中还没有程序，此配方将是第一个程序。</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>取消下载</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
    <message>
        <source>No connection: the present program of the controller is unknown.</source>
        <translation>没有连接：控制器当前的程序未知。</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>The controller already has this program.</source>
        <translation>控制器中已有此程序。</translation>
    </message>
    <message>
        <source>Close the cam</source>
        <translation>闭合凸轮</translation>
    </message>
    <message>
        <source>Confirm advance</source>
        <translation>确认净进给</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>保存 %1</translation>
    </message>
    <message>
        <source>Give a reason …</source>
        <translation>说明原因 …</translation>
    </message>
</context>
<context>
    <name>DryRunSection</name>
    <message>
        <source>The recipe cannot be executed. Correct it on the Motion page.</source>
        <translation>此配方无法执行。请在“运动”页修正。</translation>
    </message>
    <message>
        <source>Master %1°</source>
        <translation>主轴 %1°</translation>
    </message>
    <message>
        <source>Knife %1°</source>
        <translation>切刀 %1°</translation>
    </message>
    <message>
        <source>%1, at full speed</source>
        <translation>%1，全速时</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>切刀</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Only on the screen: the machine does not move, and nothing is sent to the controller. Turn the left dial.</source>
        <translation>仅在屏幕上演示：机器不动，也不向控制器发送数据。请转动左侧表盘。</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>回到起点</translation>
    </message>
</context>
<context>
    <name>EndOrderSheet</name>
    <message>
        <source>End order</source>
        <translation>结束订单</translation>
    </message>
    <message>
        <source>End %1 at %2 good bags? An ended order cannot be continued. The run goes on.</source>
        <translation>在合格 %2 袋时结束 %1？已结束的订单无法继续。机器继续运行。</translation>
    </message>
</context>
<context>
    <name>Explained</name>
    <message>
        <source>How this is calculated</source>
        <translation>计算方法</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>更改：%1</translation>
    </message>
</context>
<context>
    <name>ExplanationSheet</name>
    <message>
        <source>This value is entered, not calculated. The range is %1 to %2.</source>
        <translation>此值为输入值，不是计算值。范围为 %1 至 %2。</translation>
    </message>
    <message>
        <source>Enter this value instead</source>
        <translation>改为输入此值</translation>
    </message>
</context>
<context>
    <name>FaultCard</name>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 个</translation>
    </message>
</context>
<context>
    <name>FiguresSection</name>
    <message>
        <source>Communication</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>应答时间</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>控制器：</translation>
    </message>
    <message>
        <source>Responses, max. %1 per minute</source>
        <translation>应答，每分钟最多 %1</translation>
    </message>
    <message>
        <source>99 % of responses within, max. %1 ms</source>
        <translation>99 % 的应答不超过，最长 %1 毫秒</translation>
    </message>
    <message>
        <source>Errors, max. %1 per minute</source>
        <translation>错误，每分钟最多 %1</translation>
    </message>
    <message>
        <source>Reset counters</source>
        <translation>计数清零</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>导出 CSV</translation>
    </message>
    <message>
        <source>Statistics as CSV</source>
        <translation>统计导出为 CSV</translation>
    </message>
</context>
<context>
    <name>FilmCard</name>
    <message>
        <source>Film</source>
        <translation>薄膜</translation>
    </message>
    <message>
        <source>mark error %1</source>
        <translation>色标误差 %1</translation>
    </message>
    <message>
        <source>Mark sensor</source>
        <translation>色标传感器</translation>
    </message>
</context>
<context>
    <name>FilmLegend</name>
    <message>
        <source>mark detected</source>
        <translation>检出的色标</translation>
    </message>
    <message>
        <source>missed mark, calculated</source>
        <translation>漏检色标（推算）</translation>
    </message>
    <message>
        <source>next expected mark</source>
        <translation>下一个预期色标</translation>
    </message>
    <message>
        <source>product</source>
        <translation>产品</translation>
    </message>
    <message>
        <source>next cut</source>
        <translation>下一次切断</translation>
    </message>
    <message>
        <source>skipped cut</source>
        <translation>略过的切断</translation>
    </message>
</context>
<context>
    <name>FilmReasonSheet</name>
    <message>
        <source>Why is another film reel used?</source>
        <translation>为何使用其他膜卷？</translation>
    </message>
    <message>
        <source>Enter the reason for the audit trail.</source>
        <translation>请输入原因，用于审计追踪。</translation>
    </message>
</context>
<context>
    <name>FilmSheet</name>
    <message>
        <source>Start is blocked</source>
        <translation>启动被禁止</translation>
    </message>
    <message>
        <source>Override …</source>
        <translation>放行…</translation>
    </message>
</context>
<context>
    <name>FirstController</name>
    <message>
        <source>Simulated controller</source>
        <translation>仿真控制器</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Use this connection</source>
        <translation>使用此连接</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Find the controller</source>
        <translation>查找控制器</translation>
    </message>
    <message>
        <source>on all ports with the usual settings; takes seconds</source>
        <translation>所有端口，常用设置；只需数秒</translation>
    </message>
    <message>
        <source>Choose the port</source>
        <translation>选择端口</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>for training; moves no machine</source>
        <translation>用于培训；不驱动机器</translation>
    </message>
    <message>
        <source>No controller with the usual settings. All settings take up to 15 min for each port.</source>
        <translation>常用设置下没有控制器。搜索全部设置时，每个端口最多需要 15 分钟。</translation>
    </message>
    <message>
        <source>Search all settings</source>
        <translation>搜索全部设置</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
</context>
<context>
    <name>FirstLanguage</name>
    <message>
        <source>The Stop button is always available. It is not an emergency stop: use the machine&apos;s emergency-stop switch.</source>
        <translation>“停止”按钮始终可用。它不是急停：急停请用机器的急停开关。</translation>
    </message>
</context>
<context>
    <name>FirstMachine</name>
    <message>
        <source>Limits and more</source>
        <translation>限值及其他</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>按现有值</translation>
    </message>
</context>
<context>
    <name>FirstPicture</name>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>面板</translation>
    </message>
</context>
<context>
    <name>FirstPin</name>
    <message>
        <source>%1 is set. Add other users in Settings &gt; Users: operators start, stop and change bag length and rate, technicians also set cam and machine.</source>
        <translation>%1 已设置。请在“设置 &gt; 用户”中添加其他用户：操作员可启停并更改袋长和速率，技术员还可设置凸轮和机器。</translation>
    </message>
    <message>
        <source>A PIN protects the cam, the machine and the connection; operators start, stop and change bag length and rate without a PIN. Until a PIN is set, all users have full access.</source>
        <translation>PIN 保护凸轮、机器和通信；操作员无需 PIN 即可启停并更改袋长和速率。设置 PIN 之前，任何人都有全部权限。</translation>
    </message>
    <message>
        <source>Set the first PIN</source>
        <translation>设置第一个 PIN</translation>
    </message>
</context>
<context>
    <name>FirstRecipe</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the recipe</source>
        <translation>配方名称</translation>
    </message>
</context>
<context>
    <name>FirstStart</name>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>访问权限</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>First recipe</source>
        <translation>第一个配方</translation>
    </message>
    <message>
        <source>First start · %1 of %2</source>
        <translation>首次启动 · 第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>取消下载</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
</context>
<context>
    <name>FolderInUse</name>
    <message>
        <source>Another CamPanel uses the data in %1. Close the other one: this panel then starts.</source>
        <translation>另一个 CamPanel 正在使用 %1 中的数据。关闭另一个后，本面板即启动。</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>关闭本窗口</translation>
    </message>
</context>
<context>
    <name>ForceCard</name>
    <message>
        <source>Force N over position</source>
        <translation>力（N）随位置的变化</translation>
    </message>
    <message>
        <source>at the stop: %1, %2 to %3</source>
        <translation>终点要求：%1，%2 至 %3</translation>
    </message>
</context>
<context>
    <name>FrameSheet</name>
    <message>
        <source>Earlier</source>
        <translation>较早</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>较晚</translation>
    </message>
</context>
<context>
    <name>FramesSection</name>
    <message>
        <source>Frames</source>
        <translation>报文</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>No frames of this kind.</source>
        <translation>没有此类报文。</translation>
    </message>
    <message>
        <source>Frames as text</source>
        <translation>报文导出为文本</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
</context>
<context>
    <name>HoldKey</name>
    <message>
        <source>Try %1</source>
        <translation>测试%1</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>测试</translation>
    </message>
</context>
<context>
    <name>HomingSection</name>
    <message>
        <source>Position from reference</source>
        <translation>自回零起的位置</translation>
    </message>
</context>
<context>
    <name>IoSection</name>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Fault bits</source>
        <translation>故障位</translation>
    </message>
    <message>
        <source>Warning bits</source>
        <translation>警告位</translation>
    </message>
    <message>
        <source>No data from the controller: grey values were received last.</source>
        <translation>没有收到控制器的数据：灰色为最后收到的值。</translation>
    </message>
    <message>
        <source>This controller reports the counts of its inputs, not the levels of its pins. A filled lamp means on.</source>
        <translation>此控制器报告输入的计数，而不是引脚电平。实心灯表示接通。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Input or output</source>
        <translation>输入或输出</translation>
    </message>
</context>
<context>
    <name>JamSheet</name>
    <message>
        <source>Jams at the jaws</source>
        <translation>封切口卡料</translation>
    </message>
    <message>
        <source>Torque of the knife in per cent of its rated torque, over the angle of its shaft from the cut.</source>
        <translation>切刀转矩占额定转矩的百分比，横轴为刀轴相对切断点的角度。</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>closes</source>
        <translation>开始闭合</translation>
    </message>
    <message>
        <source>learned band</source>
        <translation>学习到的范围</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>last jam</source>
        <translation>上次卡料</translation>
    </message>
    <message>
        <source>Monitoring of the torque, reported every %1</source>
        <translation>转矩监控，报告间隔 %1</translation>
    </message>
    <message>
        <source>Last jam; jams since power-up: %1</source>
        <translation>上次卡料；通电以来的次数：%1</translation>
    </message>
    <message>
        <source>Residue on the knife</source>
        <translation>切刀上的残留</translation>
    </message>
</context>
<context>
    <name>JogSection</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Knife angle</source>
        <translation>切刀角度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
    </message>
</context>
<context>
    <name>KindInputs</name>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>接近</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>压装</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>下一组：%1</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1，第 %2 / %3 组</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>型值点</translation>
    </message>
    <message>
        <source>View and tools</source>
        <translation>视图与工具</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>运动段</translation>
    </message>
</context>
<context>
    <name>KindSheet</name>
    <message>
        <source>A knife that follows the film while it seals</source>
        <translation>切刀在封切时跟随薄膜</translation>
    </message>
    <message>
        <source>A distance, from rest to rest</source>
        <translation>从静止到静止走一段距离</translation>
    </message>
    <message>
        <source>From one speed to another constant speed</source>
        <translation>从一个速度变到另一个速度并保持</translation>
    </message>
    <message>
        <source>A curve through knots that follows a master</source>
        <translation>过型值点的曲线，从轴跟随主轴</translation>
    </message>
    <message>
        <source>Approach, probe, press, hold, return</source>
        <translation>快进、探测、压装、保压、返回</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>新建程序</translation>
    </message>
    <message>
        <source>Replaces the recipe on this page; Undo restores the old recipe</source>
        <translation>将取代本页的配方，可用“撤销”恢复</translation>
    </message>
    <message>
        <source>Segments by laws, one after another, that follow a master</source>
        <translation>由各运动规律依次组成、跟随主轴的运动段</translation>
    </message>
</context>
<context>
    <name>KnifeCard</name>
    <message>
        <source>Knife</source>
        <translation>切刀</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>转矩</translation>
    </message>
</context>
<context>
    <name>KnifeSheet</name>
    <message>
        <source>Knife</source>
        <translation>切刀</translation>
    </message>
    <message>
        <source>Knife speed %1</source>
        <translation>切刀速度 %1</translation>
    </message>
</context>
<context>
    <name>KnotSheet</name>
    <message>
        <source>Add after</source>
        <translation>在后面插入</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Close smoothly</source>
        <translation>平滑闭合</translation>
    </message>
    <message>
        <source>CSV files</source>
        <translation>CSV 文件</translation>
    </message>
    <message>
        <source>Knot %1</source>
        <translation>型值点 %1</translation>
    </message>
</context>
<context>
    <name>LastStopCard</name>
    <message>
        <source>No stop yet</source>
        <translation>尚无停机</translation>
    </message>
</context>
<context>
    <name>LawPicker</name>
    <message>
        <source>The figures are those of the ratios set by hand; the law that is gentlest with its own ramps is first</source>
        <translation>数值按手动设定的比例计算；采用自身最佳斜坡时最平缓的规律排在最前</translation>
    </message>
    <message>
        <source>The gentlest law is first, each with the ramps that suit it; hold a law to compare its curves</source>
        <translation>按平缓程度排序，各规律采用适合自身的斜坡；长按某一规律以比较曲线</translation>
    </message>
    <message>
        <source>Peak values of each law for this recipe; hold a law to compare its curves</source>
        <translation>各规律用于本配方的峰值；长按某一规律以比较曲线</translation>
    </message>
    <message>
        <source>Color: %1, grey: %2</source>
        <translation>彩色：%1，灰色：%2</translation>
    </message>
    <message>
        <source>End comparison</source>
        <translation>结束比较</translation>
    </message>
</context>
<context>
    <name>LawRow</name>
    <message>
        <source>This law exceeds a limit with this recipe. Hold the law to compare.</source>
        <translation>此规律用于本配方时超出限值。长按可比较。</translation>
    </message>
    <message>
        <source>This law exceeds a limit with this recipe.</source>
        <translation>此规律用于本配方时超出限值。</translation>
    </message>
</context>
<context>
    <name>LengthCard</name>
    <message>
        <source>Scrap bag, %1</source>
        <translation>废袋，%1</translation>
    </message>
    <message>
        <source>Bag of %1 lengths, skipped cut</source>
        <translation>%1 个袋长，略过切断</translation>
    </message>
    <message>
        <source>Bag length, %1</source>
        <translation>袋长，%1</translation>
    </message>
    <message>
        <source>Scrap bag</source>
        <translation>废袋</translation>
    </message>
    <message>
        <source>Bag length</source>
        <translation>袋长</translation>
    </message>
    <message>
        <source>%1 of %2 within</source>
        <translation>%2 袋中 %1 袋合格</translation>
    </message>
    <message>
        <source>%1 of %2 within, scrap: %3</source>
        <translation>%2 袋中 %1 袋合格，废袋 %3</translation>
    </message>
</context>
<context>
    <name>LineFilm</name>
    <message>
        <source>Knife</source>
        <translation>切刀</translation>
    </message>
</context>
<context>
    <name>LogFilterDialogs</name>
    <message>
        <source>Word</source>
        <translation>文字</translation>
    </message>
</context>
<context>
    <name>LogFilterSheet</name>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>− 7 d</source>
        <translation>− 7 天</translation>
    </message>
    <message>
        <source>− 1 d</source>
        <translation>− 1 天</translation>
    </message>
    <message>
        <source>+ 1 d</source>
        <translation>+ 1 天</translation>
    </message>
    <message>
        <source>+ 7 d</source>
        <translation>+ 7 天</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 小时</translation>
    </message>
    <message>
        <source>− 10 min</source>
        <translation>− 10 分</translation>
    </message>
    <message>
        <source>+ 10 min</source>
        <translation>+ 10 分</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 小时</translation>
    </message>
    <message>
        <source>This day only</source>
        <translation>仅这一天</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translation>清除筛选</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
</context>
<context>
    <name>LogFilterStrip</name>
    <message>
        <source>Only: %1</source>
        <translation>仅：%1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
</context>
<context>
    <name>LoginHost</name>
    <message>
        <source>Your PIN is too short</source>
        <translation>您的 PIN 太短</translation>
    </message>
</context>
<context>
    <name>LoginSheet</name>
    <message>
        <source>Log in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Choose your name.</source>
        <translation>请选择您的姓名。</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Choose your name, then enter your PIN.</source>
        <translation>先选择姓名，再输入 PIN。</translation>
    </message>
    <message>
        <source>Please wait …</source>
        <translation>请稍候…</translation>
    </message>
    <message>
        <source>Enter your PIN.</source>
        <translation>请输入 PIN。</translation>
    </message>
</context>
<context>
    <name>MachineDrawing</name>
    <message>
        <source>Drawing of the machine</source>
        <translation>机器示意图</translation>
    </message>
</context>
<context>
    <name>MachineSection</name>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>Reasons, ideal rate</source>
        <translation>原因、理想速率</translation>
    </message>
    <message>
        <source>Stops and shifts</source>
        <translation>停机与班次</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Panel&apos;s permit</source>
        <translation>面板许可</translation>
    </message>
    <message>
        <source>Bag tolerance ±</source>
        <translation>袋长公差 ±</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Light tower and horn</source>
        <translation>信号灯和蜂鸣器</translation>
    </message>
    <message>
        <source>What each state shows</source>
        <translation>各状态的显示</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Pulses, direction</source>
        <translation>脉冲、方向</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>needs level %1</source>
        <translation>需要%1级别</translation>
    </message>
</context>
<context>
    <name>MaintenancePage</name>
    <message>
        <source>Diagnostics</source>
        <translation>通信诊断</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>通信统计</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>报文</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障模拟</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>包装</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>输入输出</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>空运行</translation>
    </message>
    <message>
        <source>Connection to the controller</source>
        <translation>与控制器的通信</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>Panel data</source>
        <translation>面板数据</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>扫码枪</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
</context>
<context>
    <name>MarkWizardSheet</name>
    <message>
        <source>Mark sensor to knife</source>
        <translation>色标传感器到切刀</translation>
    </message>
    <message>
        <source>Step 1 of 5: introduction</source>
        <translation>第 1 步，共 5 步：说明</translation>
    </message>
    <message>
        <source>Step 2 of 5: cut bags</source>
        <translation>第 2 步，共 5 步：切袋</translation>
    </message>
    <message>
        <source>Step 3 of 5: measure</source>
        <translation>第 3 步，共 5 步：测量</translation>
    </message>
    <message>
        <source>Step 4 of 5: write</source>
        <translation>第 4 步，共 5 步：写入</translation>
    </message>
    <message>
        <source>Step 5 of 5: check</source>
        <translation>第 5 步，共 5 步：检查</translation>
    </message>
    <message>
        <source>Old distance</source>
        <translation>原距离</translation>
    </message>
    <message>
        <source>New distance</source>
        <translation>新距离</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Read ruler</source>
        <translation>读尺</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>输入…</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Cut behind mark</source>
        <translation>切断在色标后</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Delete the measurement</source>
        <translation>删除测量值</translation>
    </message>
</context>
<context>
    <name>MasterDialCard</name>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
</context>
<context>
    <name>MasterDrawing</name>
    <message>
        <source>Encoder wheel on the film</source>
        <translation>薄膜上的编码器测量轮</translation>
    </message>
    <message>
        <source>Encoder on the shaft of the line</source>
        <translation>生产线转轴上的编码器</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>切刀</translation>
    </message>
    <message>
        <source>film</source>
        <translation>薄膜</translation>
    </message>
</context>
<context>
    <name>MasterSection</name>
    <message>
        <source>Set up</source>
        <translation>设置</translation>
    </message>
</context>
<context>
    <name>MasterSetupSection</name>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
</context>
<context>
    <name>MoreSheet</name>
    <message>
        <source>View and tools</source>
        <translation>视图与工具</translation>
    </message>
    <message>
        <source>Position curve</source>
        <translation>位置曲线</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Jerk curve</source>
        <translation>跃度曲线</translation>
    </message>
    <message>
        <source>Compare with controller</source>
        <translation>与控制器比较</translation>
    </message>
    <message>
        <source>Rows, pulses, errors</source>
        <translation>行、脉冲、误差</translation>
    </message>
    <message>
        <source>Restore stored recipe</source>
        <translation>恢复已存配方</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>数据表</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>controller in grey</source>
        <translation>灰色为控制器的曲线</translation>
    </message>
    <message>
        <source>Edited, active, saved</source>
        <translation>编辑、运行、保存</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Fastest rate over length</source>
        <translation>各袋长的最高速率</translation>
    </message>
    <message>
        <source>Regime map</source>
        <translation>可行域图</translation>
    </message>
    <message>
        <source>Torque curve</source>
        <translation>转矩曲线</translation>
    </message>
    <message>
        <source>needs the inertia, see Settings, Machine</source>
        <translation>需要惯量，见“设置 &gt; 机器”</translation>
    </message>
    <message>
        <source>Operator&apos;s page</source>
        <translation>操作员页面</translation>
    </message>
</context>
<context>
    <name>NameKeypad</name>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
</context>
<context>
    <name>NavigationBar</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Trends</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
</context>
<context>
    <name>NetworkSheet</name>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Network port</source>
        <translation>网口</translation>
    </message>
    <message>
        <source>By DHCP</source>
        <translation>DHCP 自动</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
</context>
<context>
    <name>NewOrderSheet</name>
    <message>
        <source>New order</source>
        <translation>新订单</translation>
    </message>
    <message>
        <source>Good bags</source>
        <translation>合格袋数</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Any recipe</source>
        <translation>任意配方</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>Order: enter or scan it</source>
        <translation>订单：输入或扫描</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>批号</translation>
    </message>
    <message>
        <source>Lot: enter or scan it</source>
        <translation>批号：输入或扫描</translation>
    </message>
    <message>
        <source>At the quantity</source>
        <translation>达到数量时</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Message before</source>
        <translation>提前提示</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>First bag checked by</source>
        <translation>首袋检查人</translation>
    </message>
    <message>
        <source>Bags before the end</source>
        <translation>结束前袋数</translation>
    </message>
    <message>
        <source>Add to the queue</source>
        <translation>加入队列</translation>
    </message>
    <message>
        <source>Start order</source>
        <translation>开始订单</translation>
    </message>
</context>
<context>
    <name>NewPinSheet</name>
    <message>
        <source>The two PINs differ. Enter the new PIN again.</source>
        <translation>两次输入的 PIN 不同。请重新输入。</translation>
    </message>
    <message>
        <source>Repeat PIN</source>
        <translation>再次输入</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>新 PIN</translation>
    </message>
    <message>
        <source>Enter the same PIN again.</source>
        <translation>请再次输入同一 PIN。</translation>
    </message>
    <message>
        <source>Enter the new PIN.</source>
        <translation>请输入新 PIN。</translation>
    </message>
    <message>
        <source>%1 to 8 digits. A forgotten PIN cannot be read; a user of the level Service can set a new PIN.</source>
        <translation>%1 至 8 位数字。忘记的 PIN 无法读出；“维护”级用户可以设定新的 PIN。</translation>
    </message>
</context>
<context>
    <name>NewUser</name>
    <message>
        <source>Name of the user</source>
        <translation>用户名</translation>
    </message>
    <message>
        <source>PIN of %1</source>
        <translation>%1 的 PIN</translation>
    </message>
</context>
<context>
    <name>NewUserSheet</name>
    <message>
        <source>New user</source>
        <translation>新用户</translation>
    </message>
    <message>
        <source>The first user has the level Service and adds the other users. Keep this PIN safe: a forgotten PIN cannot be read from the panel.</source>
        <translation>第一个用户为“维护”级，可添加其他用户。请妥善保存此 PIN：忘记的 PIN 无法从面板读出。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Next: PIN</source>
        <translation>下一步：PIN</translation>
    </message>
</context>
<context>
    <name>NextStepButton</name>
    <message>
        <source>Downloading</source>
        <translation>正在下载</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
    <message>
        <source>in the controller</source>
        <translation>在控制器中</translation>
    </message>
    <message>
        <source>next cycle</source>
        <translation>下一周期</translation>
    </message>
    <message>
        <source>to the controller</source>
        <translation>到控制器</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>没有连接</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>保存 %1</translation>
    </message>
</context>
<context>
    <name>NumbersSheet</name>
    <message>
        <source>How this is calculated</source>
        <translation>计算方法</translation>
    </message>
</context>
<context>
    <name>NumericKeypad</name>
    <message>
        <source>%1 to %2 · now %3</source>
        <translation>%1 至 %2 · 当前 %3</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Enter a whole number.</source>
        <translation>请输入整数。</translation>
    </message>
    <message>
        <source>%1 to %2, possible up to %3 · now %4</source>
        <translation>%1 至 %2，可行至 %3 · 当前 %4</translation>
    </message>
</context>
<context>
    <name>OeeCard</name>
    <message>
        <source>OEE</source>
        <translation>OEE</translation>
    </message>
    <message>
        <source>Availability</source>
        <translation>时间开动率</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>性能开动率</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>合格品率</translation>
    </message>
</context>
<context>
    <name>OfferSheet</name>
    <message>
        <source>Searching …</source>
        <translation>正在查找…</translation>
    </message>
    <message>
        <source>Choose a file to view its content.</source>
        <translation>请选择文件以查看其内容。</translation>
    </message>
</context>
<context>
    <name>OfferedRow</name>
    <message>
        <source>Offered: %1</source>
        <translation>提供：%1</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>接收</translation>
    </message>
</context>
<context>
    <name>OrderFilterSheet</name>
    <message>
        <source>Order, lot or number</source>
        <translation>订单、批号或编号</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>文字</translation>
    </message>
</context>
<context>
    <name>OrderList</name>
    <message>
        <source>No order matches the filter.</source>
        <translation>没有符合筛选的订单。</translation>
    </message>
    <message>
        <source>No order was started yet.</source>
        <translation>尚未开始任何订单。</translation>
    </message>
    <message>
        <source>rejected %1 · empty %2</source>
        <translation>剔除 %1 · 空袋 %2</translation>
    </message>
</context>
<context>
    <name>OrderRecipePicker</name>
    <message>
        <source>Recipe of the order</source>
        <translation>订单的配方</translation>
    </message>
    <message>
        <source>Any recipe</source>
        <translation>任意配方</translation>
    </message>
</context>
<context>
    <name>OrderStrip</name>
    <message>
        <source>Order</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空袋</translation>
    </message>
    <message>
        <source>Orders that wait: %1</source>
        <translation>等待的订单：%1</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>新订单</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Offered by the plant: %1</source>
        <translation>工厂提供：%1</translation>
    </message>
</context>
<context>
    <name>OrdersSheet</name>
    <message>
        <source>Orders</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>No order waits.</source>
        <translation>没有等待的订单。</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Orders as CSV</source>
        <translation>订单导出为 CSV</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>新订单</translation>
    </message>
    <message>
        <source>Stops and OEE</source>
        <translation>停机与 OEE</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Not confirmed yet. Confirm or cancel first.</source>
        <translation>尚未确认。请先确认或取消。</translation>
    </message>
</context>
<context>
    <name>PackingSection</name>
    <message>
        <source>Measure marks</source>
        <translation>测量色标</translation>
    </message>
    <message>
        <source>Sensor to knife …</source>
        <translation>传感器到切刀…</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>色标信号</translation>
    </message>
    <message>
        <source>Jam</source>
        <translation>卡料</translation>
    </message>
</context>
<context>
    <name>PackingSheet</name>
    <message>
        <source>Marks, cuts and film</source>
        <translation>色标、切断与薄膜</translation>
    </message>
    <message>
        <source>Mark error of the last cut</source>
        <translation>上一次切断的色标误差</translation>
    </message>
    <message>
        <source>Mark distance</source>
        <translation>色标间距</translation>
    </message>
    <message>
        <source>Shift of the next cut</source>
        <translation>下一次切断的移动量</translation>
    </message>
    <message>
        <source>Length correction</source>
        <translation>袋长修正量</translation>
    </message>
    <message>
        <source>Corrections at limit</source>
        <translation>达到限值的修正</translation>
    </message>
    <message>
        <source>Tracked marks</source>
        <translation>已跟踪的色标</translation>
    </message>
    <message>
        <source>Missing marks</source>
        <translation>缺失的色标</translation>
    </message>
    <message>
        <source>Unexpected marks</source>
        <translation>多余的色标</translation>
    </message>
    <message>
        <source>Cuts and film</source>
        <translation>切断与薄膜</translation>
    </message>
    <message>
        <source>Products</source>
        <translation>产品</translation>
    </message>
    <message>
        <source>Skipped cuts, product in the way</source>
        <translation>因产品阻挡略过的切断</translation>
    </message>
    <message>
        <source>Bags without product</source>
        <translation>无产品的袋</translation>
    </message>
    <message>
        <source>Film saved</source>
        <translation>节省薄膜</translation>
    </message>
    <message>
        <source>Following error of the knife</source>
        <translation>切刀跟随误差</translation>
    </message>
    <message>
        <source>Following error of the film</source>
        <translation>薄膜跟随误差</translation>
    </message>
</context>
<context>
    <name>PagesSheet</name>
    <message>
        <source>More pages</source>
        <translation>更多页面</translation>
    </message>
</context>
<context>
    <name>ParameterFoot</name>
    <message>
        <source>Changes take effect at once. Press Save to keep the values after power-off.</source>
        <translation>更改立即生效。按“保存”后断电不丢失。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>Apply %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
</context>
<context>
    <name>ParityPicker</name>
    <message>
        <source>Parity and stop bits</source>
        <translation>校验位和停止位</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无校验</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>偶校验</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>奇校验</translation>
    </message>
    <message>
        <source>1 stop bit</source>
        <translation>1 位停止位</translation>
    </message>
    <message>
        <source>2 stop bits</source>
        <translation>2 位停止位</translation>
    </message>
</context>
<context>
    <name>PermitSection</name>
    <message>
        <source>Start permit</source>
        <translation>启动许可</translation>
    </message>
</context>
<context>
    <name>PortPicker</name>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug the adapter in and press Search again.</source>
        <translation>本机没有串口。请插入适配器，再按“重新搜索”。</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>重新搜索</translation>
    </message>
</context>
<context>
    <name>PossibleRate</name>
    <message>
        <source>Limit: %1 %2</source>
        <translation>限值：%1 %2</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>最高 %1</translation>
    </message>
</context>
<context>
    <name>ProgramNames</name>
    <message>
        <source>%1 · v%2</source>
        <translation>%1 · 第 %2 版</translation>
    </message>
    <message>
        <source>%1 · v%2, edited</source>
        <translation>%1 · 第 %2 版（已修改）</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1，未保存</translation>
    </message>
</context>
<context>
    <name>ProofSheet</name>
    <message>
        <source>Program in the controller</source>
        <translation>控制器中的程序</translation>
    </message>
    <message>
        <source>Edited on this panel</source>
        <translation>本面板上编辑的</translation>
    </message>
    <message>
        <source>Active in the controller</source>
        <translation>控制器中运行的</translation>
    </message>
    <message>
        <source>Active in the controller (last known)</source>
        <translation>控制器中运行的（最后已知）</translation>
    </message>
    <message>
        <source>Saved in the controller</source>
        <translation>控制器中保存的</translation>
    </message>
    <message>
        <source>Saved in the controller (last known)</source>
        <translation>控制器中保存的（最后已知）</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Compare with the controller</source>
        <translation>与控制器比较</translation>
    </message>
    <message>
        <source>%1, differences from the active program: %2</source>
        <translation>%1，与运行中的程序有 %2 处不同</translation>
    </message>
</context>
<context>
    <name>QueueRow</name>
    <message>
        <source>One place up</source>
        <translation>上移一位</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Start order</source>
        <translation>开始订单</translation>
    </message>
</context>
<context>
    <name>RateCard</name>
    <message>
        <source>Rate of the line, bags/min</source>
        <translation>生产线速率，袋/分</translation>
    </message>
    <message>
        <source>Slowed to %1, bags/min</source>
        <translation>已减至 %1，袋/分</translation>
    </message>
    <message>
        <source>Rate, bags/min</source>
        <translation>速率，袋/分</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>bags/min</source>
        <translation>袋/分</translation>
    </message>
    <message>
        <source>%1 bags</source>
        <translation>共 %1 袋</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>最高 %1</translation>
    </message>
</context>
<context>
    <name>RatioSheet</name>
    <message>
        <source>Slow</source>
        <translation>低速</translation>
    </message>
    <message>
        <source>Cool</source>
        <translation>低热</translation>
    </message>
    <message>
        <source>Gentle</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>Sealing window</source>
        <translation>封切窗口</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>比例</translation>
    </message>
</context>
<context>
    <name>ReasonGrid</name>
    <message>
        <source>more …</source>
        <translation>更多 …</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>计划</translation>
    </message>
</context>
<context>
    <name>ReasonList</name>
    <message>
        <source>Reasons by time</source>
        <translation>按时间排列的原因</translation>
    </message>
    <message>
        <source>%1 (planned)</source>
        <translation>%1（计划）</translation>
    </message>
    <message>
        <source>No stop in this shift.</source>
        <translation>本班次无停机。</translation>
    </message>
</context>
<context>
    <name>ReasonsSheet</name>
    <message>
        <source>Reasons: %1</source>
        <translation>原因：%1</translation>
    </message>
    <message>
        <source>Reasons of a stop</source>
        <translation>停机原因</translation>
    </message>
    <message>
        <source>Planned stops are not counted as losses. Earlier stops keep their reason.</source>
        <translation>计划停机不计为损失。以前的停机保留其原因。</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>more …</source>
        <translation>更多 …</translation>
    </message>
    <message>
        <source>This group has no reasons yet.</source>
        <translation>此组尚无原因。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Standard list</source>
        <translation>标准列表</translation>
    </message>
</context>
<context>
    <name>RecipeCard</name>
    <message>
        <source>In the controller</source>
        <translation>在控制器中</translation>
    </message>
    <message>
        <source>Open on this panel</source>
        <translation>已在面板上打开</translation>
    </message>
    <message>
        <source>Stored on this panel</source>
        <translation>已存于面板</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>改名…</translation>
    </message>
    <message>
        <source>Copy …</source>
        <translation>复制…</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Download …</source>
        <translation>下载…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Codes …</source>
        <translation>条码…</translation>
    </message>
    <message>
        <source>In the controller and open here</source>
        <translation>在控制器中且在此打开</translation>
    </message>
    <message>
        <source>Approved …</source>
        <translation>批准范围 …</translation>
    </message>
</context>
<context>
    <name>RecipeComparisonSheet</name>
    <message>
        <source>Versions of %1</source>
        <translation>%1 的版本</translation>
    </message>
    <message>
        <source>Compare %1</source>
        <translation>比较 %1</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>此版改动</translation>
    </message>
    <message>
        <source>To newest</source>
        <translation>与最新版</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>没有差别</translation>
    </message>
    <message>
        <source>There is no other version to compare.</source>
        <translation>没有可比较的其他版本。</translation>
    </message>
    <message>
        <source>Choose an entry at the left.</source>
        <translation>请在左侧选择。</translation>
    </message>
    <message>
        <source>This is the newest version.</source>
        <translation>这是最新版本。</translation>
    </message>
    <message>
        <source>This is the first version.</source>
        <translation>这是第一个版本。</translation>
    </message>
    <message>
        <source>Open this version</source>
        <translation>打开此版本</translation>
    </message>
</context>
<context>
    <name>RecipeRow</name>
    <message>
        <source>v%1 · %2</source>
        <translation>第 %1 版 · %2</translation>
    </message>
    <message>
        <source>Open on this panel</source>
        <translation>已在面板上打开</translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation>在控制器中</translation>
    </message>
    <message>
        <source>In the controller and open here</source>
        <translation>在控制器中且在此打开</translation>
    </message>
</context>
<context>
    <name>RecipesPage</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>all %1 recipes</source>
        <translation>全部 %1 个配方</translation>
    </message>
    <message>
        <source>End the search</source>
        <translation>结束搜索</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>新建…</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export all …</source>
        <translation>全部导出…</translation>
    </message>
    <message>
        <source>%1 was edited and is not saved.</source>
        <translation>%1 已修改，尚未保存。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Save as version %1</source>
        <translation>保存为第 %1 版</translation>
    </message>
    <message>
        <source>Reading the recipes …</source>
        <translation>正在读取配方…</translation>
    </message>
    <message>
        <source>No recipe name contains &quot;%1&quot;. Change or clear the search.</source>
        <translation>没有名称含“%1”的配方。请更改或清除搜索。</translation>
    </message>
    <message>
        <source>There is no recipe yet. Create a recipe, or import one from a USB stick.</source>
        <translation>还没有配方。请新建，或从 U 盘导入。</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 副本</translation>
    </message>
    <message>
        <source>1 recipe</source>
        <translation>1 个配方</translation>
    </message>
    <message>
        <source>A new recipe of this kind, with the data of this machine</source>
        <translation>此类型的新配方，采用本机数据</translation>
    </message>
    <message>
        <source>Name of the new recipe</source>
        <translation>新配方的名称</translation>
    </message>
    <message>
        <source>Name of the copy</source>
        <translation>副本的名称</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>以其他名称保存</translation>
    </message>
    <message>
        <source>New name of %1</source>
        <translation>%1 的新名称</translation>
    </message>
    <message>
        <source>Export as JSON</source>
        <translation>导出为 JSON</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>删除 %1？</translation>
    </message>
    <message>
        <source>The recipe leaves the list; its versions are kept. Saving a recipe under this name restores them.</source>
        <translation>配方将从列表中移除，各版本仍保留。以同名保存配方时恢复。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 尚未保存</translation>
    </message>
    <message>
        <source>The recipe was edited. Opening another recipe without saving discards the edits.</source>
        <translation>配方已修改。不保存就打开其他配方将丢失修改。</translation>
    </message>
    <message>
        <source>Discard edits</source>
        <translation>放弃修改</translation>
    </message>
    <message>
        <source>There is no recipe file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.</source>
        <translation>U 盘和 %1 中都没有配方文件。请插入 U 盘，面板会自动找到。</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>View …</source>
        <translation>查看…</translation>
    </message>
    <message>
        <source>Import recipes</source>
        <translation>导入配方</translation>
    </message>
    <message>
        <source>Import all %1</source>
        <translation>全部导入 %1 个</translation>
    </message>
    <message>
        <source>%1 is not saved yet.</source>
        <translation>%1 尚未保存。</translation>
    </message>
</context>
<context>
    <name>RegimeSheet</name>
    <message>
        <source>Regime map</source>
        <translation>可行域图</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>不可行</translation>
    </message>
    <message>
        <source>reference lengths</source>
        <translation>参考袋长</translation>
    </message>
    <message>
        <source>Drag the dot to another length and rate.</source>
        <translation>拖动圆点以更改袋长和速率。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>RegisterRow</name>
    <message>
        <source>%1 · can be written</source>
        <translation>%1 · 可写</translation>
    </message>
</context>
<context>
    <name>RegistersSection</name>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Name contains</source>
        <translation>名称包含</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>No register name contains this text.</source>
        <translation>没有名称包含此文本的寄存器。</translation>
    </message>
    <message>
        <source>Write …</source>
        <translation>写入…</translation>
    </message>
    <message>
        <source>Group of registers</source>
        <translation>寄存器组</translation>
    </message>
    <message>
        <source>%1 registers</source>
        <translation>%1 个寄存器</translation>
    </message>
    <message>
        <source>Clear the filter</source>
        <translation>清除筛选</translation>
    </message>
</context>
<context>
    <name>ReportFilesSheet</name>
    <message>
        <source>Choose the location of the new files.</source>
        <translation>请选择新文件的位置。</translation>
    </message>
    <message>
        <source>Write file</source>
        <translation>写入文件</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>正在写入…</translation>
    </message>
</context>
<context>
    <name>RunAxis</name>
    <message>
        <source>Moves</source>
        <translation>运动次数</translation>
    </message>
    <message>
        <source>Master speed</source>
        <translation>主轴速度</translation>
    </message>
    <message>
        <source>Axis speed %1</source>
        <translation>轴速度 %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Position (%1/cycle)</source>
        <translation>位置（%1/周期）</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>周期数</translation>
    </message>
</context>
<context>
    <name>RunCutter</name>
    <message>
        <source>bags/min</source>
        <translation>袋/分</translation>
    </message>
    <message>
        <source>Knife speed %1</source>
        <translation>切刀速度 %1</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>seal %1</source>
        <translation>封口 %1</translation>
    </message>
    <message>
        <source>Bags</source>
        <translation>袋数</translation>
    </message>
    <message>
        <source>Rate of the line</source>
        <translation>生产线速率</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>最高 %1</translation>
    </message>
</context>
<context>
    <name>RunEmpty</name>
    <message>
        <source>Open Motion</source>
        <translation>打开“运动”</translation>
    </message>
    <message>
        <source>Download %1, edited</source>
        <translation>下载 %1（已编辑）</translation>
    </message>
    <message>
        <source>Download %1 v%2</source>
        <translation>下载 %1 v%2</translation>
    </message>
    <message>
        <source>Download %1</source>
        <translation>下载 %1</translation>
    </message>
</context>
<context>
    <name>RunPacking</name>
    <message>
        <source>moved</source>
        <translation>已调</translation>
    </message>
    <message>
        <source>Cut, product and length</source>
        <translation>切断、产品和长度</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
</context>
<context>
    <name>RunPress</name>
    <message>
        <source>Good / last strokes</source>
        <translation>合格数 / 最近行程数</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
</context>
<context>
    <name>ScannedEditsSheet</name>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 尚未保存</translation>
    </message>
    <message>
        <source>The recipe was edited. Opening the scanned recipe %1 without saving discards the edits.</source>
        <translation>配方已修改。不保存而打开扫描到的配方 %1 将丢失修改。</translation>
    </message>
    <message>
        <source>Discard edits</source>
        <translation>放弃修改</translation>
    </message>
    <message>
        <source>Save as version %1</source>
        <translation>保存为第 %1 版</translation>
    </message>
</context>
<context>
    <name>ScannerSection</name>
    <message>
        <source>Prefix</source>
        <translation>前缀</translation>
    </message>
    <message>
        <source>no scanner</source>
        <translation>无扫码枪</translation>
    </message>
    <message>
        <source>Last code</source>
        <translation>上次条码</translation>
    </message>
    <message>
        <source>Scan a code to test the scanner. While this section is open, a code opens no recipe.</source>
        <translation>扫描条码以测试扫码枪。此页打开时，条码不会打开配方。</translation>
    </message>
    <message>
        <source>Set the scanner to send a prefix that nobody types before each code, such as ~~, and enter the same prefix here.</source>
        <translation>请将扫码枪设为在每个条码前发送无人会输入的前缀（如 ~~），并在此输入相同前缀。</translation>
    </message>
    <message>
        <source>Prefix of the scanner</source>
        <translation>扫码枪前缀</translation>
    </message>
    <message>
        <source>Suffix of the scanner</source>
        <translation>扫码枪后缀</translation>
    </message>
</context>
<context>
    <name>SearchSheet</name>
    <message>
        <source>Search for a recipe</source>
        <translation>搜索配方</translation>
    </message>
    <message>
        <source>1 recipe</source>
        <translation>1 个配方</translation>
    </message>
    <message>
        <source>%1 recipes</source>
        <translation>%1 个配方</translation>
    </message>
</context>
<context>
    <name>SegmentMotionSheet</name>
    <message>
        <source>Motion of segment %1</source>
        <translation>第 %1 段的运动规律</translation>
    </message>
</context>
<context>
    <name>SegmentSheet</name>
    <message>
        <source>%1 · jump at the start</source>
        <translation>%1 · 起点突变</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动规律</translation>
    </message>
    <message>
        <source>Add dwell</source>
        <translation>添加休止</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Make continuous</source>
        <translation>使其连续</translation>
    </message>
    <message>
        <source>CSV files</source>
        <translation>CSV 文件</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>运动段 %1</translation>
    </message>
</context>
<context>
    <name>SensorEdgesSheet</name>
    <message>
        <source>Edges of the mark sensor</source>
        <translation>色标传感器信号</translation>
    </message>
    <message>
        <source>The film below the sensor. The newest edge is at the right; swipe for earlier ones.</source>
        <translation>传感器下方的薄膜。最新信号在右侧；滑动可查看更早的信号。</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>window of an expected mark</source>
        <translation>预期色标的窗口</translation>
    </message>
    <message>
        <source>Newest edge</source>
        <translation>最新信号</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Last edge that was not taken; edges since then: %1</source>
        <translation>上一个未采用的信号；此后信号数：%1</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>simulated or serial port</source>
        <translation>仿真或串口</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>About</source>
        <translation>关于</translation>
    </message>
    <message>
        <source>versions, disk, safety</source>
        <translation>版本、磁盘、安全</translation>
    </message>
    <message>
        <source>drive, gear, motor limits</source>
        <translation>驱动、减速比、电机限值</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>PINs, levels, audit</source>
        <translation>PIN、级别、审计</translation>
    </message>
    <message>
        <source>language, units, theme</source>
        <translation>语言、单位、主题</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Not confirmed yet. Close again to discard the entry.</source>
        <translation>尚未确认。再按一次关闭将放弃输入。</translation>
    </message>
</context>
<context>
    <name>ShelvedList</name>
    <message>
        <source>%1 · %2 · by %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消搁置</translation>
    </message>
    <message>
        <source>No alarm is shelved. To shelve a known warning for some hours, tap the warning in the list.</source>
        <translation>没有搁置的报警。如要将已知的警告搁置几小时，请在列表中点按该警告。</translation>
    </message>
</context>
<context>
    <name>ShiftsSheet</name>
    <message>
        <source>Shifts</source>
        <translation>班次</translation>
    </message>
    <message>
        <source>A shift lasts until the next one starts. It belongs to the day on which it starts.</source>
        <translation>班次持续到下一班次开始，属于其开始的那一天。</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 小时</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 小时</translation>
    </message>
    <message>
        <source>− 15 min</source>
        <translation>− 15 分</translation>
    </message>
    <message>
        <source>+ 15 min</source>
        <translation>+ 15 分</translation>
    </message>
    <message>
        <source>Add a shift</source>
        <translation>添加班次</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Working days</source>
        <translation>工作日</translation>
    </message>
</context>
<context>
    <name>SimulatedFaultsSection</name>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Sometimes</source>
        <translation>偶尔</translation>
    </message>
    <message>
        <source>Often</source>
        <translation>经常</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>全部关闭</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
</context>
<context>
    <name>SkippedCutsCard</name>
    <message>
        <source>Skipped cuts</source>
        <translation>略过的切断</translation>
    </message>
    <message>
        <source>Last: %1</source>
        <translation>最近一次：%1</translation>
    </message>
</context>
<context>
    <name>SpeedCard</name>
    <message>
        <source>following error %1</source>
        <translation>跟随误差 %1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>误差 %1</translation>
    </message>
</context>
<context>
    <name>SpeedSheet</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Of the program&apos;s rate. A slower machine seals longer.</source>
        <translation>相对于程序的速率。机器越慢，封合时间越长。</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>减速</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>加速</translation>
    </message>
</context>
<context>
    <name>StartSheet</name>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Start runs %1. Download %2 instead?</source>
        <translation>启动将运行 %1。改为下载 %2 吗？</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
    <message>
        <source>Start %1</source>
        <translation>启动 %1</translation>
    </message>
</context>
<context>
    <name>StateBar</name>
    <message>
        <source>Running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
</context>
<context>
    <name>StopListRow</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>StopListSheet</name>
    <message>
        <source>Reason of the stop</source>
        <translation>停机原因</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>No stop in this shift.</source>
        <translation>本班次无停机。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
</context>
<context>
    <name>StopQuestion</name>
    <message>
        <source>Why is the machine stopped?</source>
        <translation>机器为何停机？</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>以后</translation>
    </message>
</context>
<context>
    <name>StopsPage</name>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Trends</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Stops: %1</source>
        <translation>停机：%1</translation>
    </message>
    <message>
        <source>%1 without a reason</source>
        <translation>%1 次无原因</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Nothing was recorded in this shift.</source>
        <translation>本班次无记录。</translation>
    </message>
    <message>
        <source>Stops as CSV</source>
        <translation>停机 CSV</translation>
    </message>
    <message>
        <source>Shift report as PDF</source>
        <translation>班次报告 PDF</translation>
    </message>
    <message>
        <source>Previous shift</source>
        <translation>上一班次</translation>
    </message>
    <message>
        <source>Next shift</source>
        <translation>下一班次</translation>
    </message>
</context>
<context>
    <name>StopsSection</name>
    <message>
        <source>Stops and shifts</source>
        <translation>停机与班次</translation>
    </message>
    <message>
        <source>Shifts start at</source>
        <translation>班次开始</translation>
    </message>
    <message>
        <source>Working days</source>
        <translation>工作日</translation>
    </message>
    <message>
        <source>Reasons of a stop</source>
        <translation>停机原因</translation>
    </message>
    <message>
        <source>Name of the reason</source>
        <translation>原因名称</translation>
    </message>
    <message>
        <source>Standard list</source>
        <translation>标准列表</translation>
    </message>
    <message>
        <source>Replace the own list by the standard list? Stops keep their reasons.</source>
        <translation>用标准列表替换自定义列表？停机保留其原因。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Ideal rate (0: by recipe)</source>
        <translation>理想速率（0：按配方）</translation>
    </message>
</context>
<context>
    <name>StrokeCard</name>
    <message>
        <source>Stroke</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>误差 %1</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>力 N</translation>
    </message>
    <message>
        <source>Completed strokes are listed here.</source>
        <translation>完成的行程列在此处。</translation>
    </message>
</context>
<context>
    <name>SystemSection</name>
    <message>
        <source>Screen and system</source>
        <translation>屏幕与系统</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Network port</source>
        <translation>网口</translation>
    </message>
    <message>
        <source>The brightness of this screen cannot be set here.</source>
        <translation>此屏幕的亮度不能在这里调节。</translation>
    </message>
    <message>
        <source>Screen rotation</source>
        <translation>屏幕旋转</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Touchscreen</source>
        <translation>触摸屏</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>已校准</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>未校准</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>touch four crosses; the panel restarts</source>
        <translation>点击四个十字；面板将重启</translation>
    </message>
    <message>
        <source>Remove calibration</source>
        <translation>删除校准</translation>
    </message>
    <message>
        <source>as before the first one; the panel restarts</source>
        <translation>恢复首次校准前的状态；面板将重启</translation>
    </message>
    <message>
        <source>Clean the screen</source>
        <translation>清洁屏幕</translation>
    </message>
    <message>
        <source>30 s without touch</source>
        <translation>30 s 内触摸无效</translation>
    </message>
</context>
<context>
    <name>TextKeyboard</name>
    <message>
        <source>-</source>
        <extracomment>The letters of the language beyond a to z, small and capital, at most 27; - for none.</extracomment>
        <translation>-</translation>
    </message>
    <message>
        <source>abc</source>
        <translation>abc</translation>
    </message>
    <message>
        <source>123</source>
        <translation>123</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Capital letters</source>
        <translation>大写字母</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>%1 s ago</source>
        <translation>%1 秒前</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/秒</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>没有程序</translation>
    </message>
    <message>
        <source>Program unknown</source>
        <translation>程序未知</translation>
    </message>
    <message>
        <source>open: %1</source>
        <translation>打开：%1</translation>
    </message>
</context>
<context>
    <name>TouchCrosses</name>
    <message>
        <source>Touch the center of the cross.</source>
        <translation>请点击十字中心。</translation>
    </message>
    <message>
        <source>Cross %1 of %2</source>
        <translation>第 %1 个十字，共 %2 个</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
</context>
<context>
    <name>TowerSection</name>
    <message>
        <source>Light tower and horn</source>
        <translation>信号灯和蜂鸣器</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>TrendCard</name>
    <message>
        <source>Trend curves</source>
        <translation>趋势曲线</translation>
    </message>
    <message>
        <source>no data in this time</source>
        <translation>此时段无数据</translation>
    </message>
    <message>
        <source>n %1 · mean %2 · std dev %3 · %4 … %5 · %6 % within</source>
        <translation>n %1 · 平均 %2 · 标准差 %3 · %4 … %5 · 合格 %6 %</translation>
    </message>
    <message>
        <source>n %1 · mean %2 · std dev %3 · %4 … %5</source>
        <translation>n %1 · 平均 %2 · 标准差 %3 · %4 … %5</translation>
    </message>
    <message>
        <source>%1 · no data</source>
        <translation>%1 · 无数据</translation>
    </message>
    <message>
        <source>%1 · mean %2 · %3 … %4</source>
        <translation>%1 · 平均 %2 · %3 … %4</translation>
    </message>
    <message>
        <source>There are no data in this time. Press Now, or − for a longer time.</source>
        <translation>此时段无数据。请按“现在”，或按 − 查看更长时段。</translation>
    </message>
</context>
<context>
    <name>TrendCurvesSheet</name>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Up to three curves; one more replaces the lowest.</source>
        <translation>最多三条曲线；再选一条将替换最下面的一条。</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Bag length %1</source>
        <translation>袋长 %1</translation>
    </message>
    <message>
        <source>Deviation %1</source>
        <translation>偏差 %1</translation>
    </message>
    <message>
        <source>Mark error %1</source>
        <translation>色标误差 %1</translation>
    </message>
    <message>
        <source>Following error %1</source>
        <translation>跟随误差 %1</translation>
    </message>
    <message>
        <source>Rate bags/min</source>
        <translation>速率 袋/分</translation>
    </message>
    <message>
        <source>Response time ms</source>
        <translation>应答时间 ms</translation>
    </message>
    <message>
        <source>each bag, per bag length</source>
        <translation>每一袋，按单个袋长计</translation>
    </message>
    <message>
        <source>each bag against the set length</source>
        <translation>每一袋与设定袋长之差</translation>
    </message>
    <message>
        <source>each cut against its printed mark</source>
        <translation>每次切断与印刷色标之差</translation>
    </message>
    <message>
        <source>knife, while turning</source>
        <translation>切刀转动时</translation>
    </message>
    <message>
        <source>master, 0 at standstill</source>
        <translation>主轴的速率，停止时为 0</translation>
    </message>
    <message>
        <source>controller to the panel&apos;s requests</source>
        <translation>控制器应答面板请求的时间</translation>
    </message>
    <message>
        <source>Residue %</source>
        <translation>残留 %</translation>
    </message>
    <message>
        <source>torque at the cut, 1000 bags</source>
        <translation>切断时的转矩，1000 个袋子</translation>
    </message>
</context>
<context>
    <name>TrendsPage</name>
    <message>
        <source>%1
clock not set</source>
        <comment>from, to</comment>
        <translation>%1
时钟未设置</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 分钟</translation>
    </message>
    <message>
        <source>1 h</source>
        <translation>1 小时</translation>
    </message>
    <message>
        <source>8 h</source>
        <translation>8 小时</translation>
    </message>
    <message>
        <source>1 day</source>
        <translation>1 天</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 天</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>%1 –
%2</source>
        <comment>from, to</comment>
        <translation>%1 –
%2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Bags and trends as CSV</source>
        <translation>袋记录和趋势 CSV</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停机</translation>
    </message>
</context>
<context>
    <name>TrialCover</name>
    <message>
        <source>Keep this rotation?</source>
        <translation>保留此旋转方向？</translation>
    </message>
    <message>
        <source>Without an answer the earlier one returns in %1 s.</source>
        <translation>若不选择，%1 秒后恢复原设置。</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep this calibration of the touchscreen?</source>
        <translation>保留此触摸屏校准？</translation>
    </message>
</context>
<context>
    <name>TrimSheet</name>
    <message>
        <source>The next bags follow. Each touch moves by %1; hold a key to repeat.</source>
        <translation>从后续的袋开始生效。每次触摸移动 %1；按住可重复。</translation>
    </message>
    <message>
        <source>Save with recipe</source>
        <translation>存入配方</translation>
    </message>
    <message>
        <source>%1 back to 0</source>
        <translation>%1归零</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>One bag</source>
        <translation>单袋</translation>
    </message>
    <message>
        <source>Single cut</source>
        <translation>单次切断</translation>
    </message>
    <message>
        <source>Next bag to me</source>
        <translation>取下一袋</translation>
    </message>
    <message>
        <source>The next bags follow. Not saved with the recipe.</source>
        <translation>从后续的袋开始生效。尚未随配方保存。</translation>
    </message>
</context>
<context>
    <name>UpdateSheet</name>
    <message>
        <source>Installed: CamPanel %1</source>
        <translation>已安装：CamPanel %1</translation>
    </message>
    <message>
        <source>Choose a version.</source>
        <translation>请选择一个版本。</translation>
    </message>
    <message>
        <source>There is no package of CamPanel on a USB stick. Plug a stick in; the panel finds it automatically.</source>
        <translation>U 盘上没有 CamPanel 软件包。插入 U 盘后，面板会自动找到。</translation>
    </message>
    <message>
        <source>The version before the last update is kept on this panel.</source>
        <translation>本面板保留了上次更新前的版本。</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>恢复到 %1</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
</context>
<context>
    <name>UserSheet</name>
    <message>
        <source>Yes, remove</source>
        <translation>确认删除</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>新 PIN</translation>
    </message>
</context>
<context>
    <name>UsersSection</name>
    <message>
        <source>Users</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>No PIN is set: all users have full access until the first user is added. Viewing and Stop never need a login.</source>
        <translation>尚未设定 PIN：添加第一个用户之前，任何人都有全部权限。查看和停止始终无需登录。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Nobody logged in · %1</source>
        <translation>无人登录 · %1</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Add a user</source>
        <translation>添加用户</translation>
    </message>
    <message>
        <source>view and stop</source>
        <translation>查看和停止</translation>
    </message>
    <message>
        <source>operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Record of changes</source>
        <translation>更改记录</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>新 PIN</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>View and stop</source>
        <translation>查看和停止</translation>
    </message>
    <message>
        <source>operators must log in</source>
        <translation>操作员也须登录</translation>
    </message>
    <message>
        <source>First user</source>
        <translation>第一个用户</translation>
    </message>
    <message>
        <source>Logout without touch after</source>
        <translation>无触摸自动退出时间</translation>
    </message>
    <message>
        <source>Row or register</source>
        <translation>行号或寄存器</translation>
    </message>
</context>
<context>
    <name>VerdictBar</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
</context>
<context>
    <name>VersionsSection</name>
    <message>
        <source>Versions and disk</source>
        <translation>版本与磁盘</translation>
    </message>
</context>
<context>
    <name>WindowLine</name>
    <message>
        <source>Give a reason …</source>
        <translation>说明原因 …</translation>
    </message>
</context>
<context>
    <name>WindowReasonSheet</name>
    <message>
        <source>Why outside the approved window?</source>
        <translation>为何超出批准范围？</translation>
    </message>
    <message>
        <source>The reason is shown until the machine runs within the window again, and kept in the audit trail.</source>
        <translation>原因会一直显示，直到机器回到批准范围内，并记入审计追踪。</translation>
    </message>
    <message>
        <source>Film or product differs</source>
        <translation>膜或产品有差异</translation>
    </message>
    <message>
        <source>Adapted to the line before or after</source>
        <translation>配合上下游设备</translation>
    </message>
    <message>
        <source>Trial, approved by word</source>
        <translation>试验，口头批准</translation>
    </message>
    <message>
        <source>Another reason …</source>
        <translation>其他原因 …</translation>
    </message>
</context>
<context>
    <name>WindowReasonText</name>
    <message>
        <source>Why outside the approved window?</source>
        <translation>为何超出批准范围？</translation>
    </message>
</context>
<context>
    <name>WindowsSheet</name>
    <message>
        <source>Approved values of %1</source>
        <translation>%1 的批准范围</translation>
    </message>
    <message>
        <source>A value outside needs a reason. The limits of the machine stay.</source>
        <translation>超出范围的数值须说明原因。机器限值不变。</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>No window for %1</source>
        <translation>%1 不设批准范围</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>ZonePicker</name>
    <message>
        <source>Time zone</source>
        <translation>时区</translation>
    </message>
</context>
</TS>
