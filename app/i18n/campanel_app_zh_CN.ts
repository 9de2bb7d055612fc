<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>AccessSentences</name>
    <message>
        <source>View only</source>
        <translation>仅查看</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>技术员</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>see everything, stop the machine</source>
        <translation>查看全部内容，停止机器</translation>
    </message>
    <message>
        <source>start, bag length, rate, recipes, alarms</source>
        <translation>启动、袋长、速度、配方、报警</translation>
    </message>
    <message>
        <source>also the cam, machine, packing, connection</source>
        <translation>另可设置凸轮、机器、包装、连接</translation>
    </message>
    <message>
        <source>also users and single registers</source>
        <translation>另可管理用户和单个寄存器</translation>
    </message>
    <message>
        <source>Whoever operates the machine logs in. Stop needs no login.</source>
        <translation>操作机器者须登录。停止无需登录。</translation>
    </message>
    <message>
        <source>This is for a technician or for service. These may do it:</source>
        <translation>此操作限技术员或维护人员。以下人员可以操作：</translation>
    </message>
    <message>
        <source>This is for service. These may do it:</source>
        <translation>此操作限维护人员。以下人员可以操作：</translation>
    </message>
    <message>
        <source>A PIN has %1 to %2 digits.</source>
        <translation>PIN 为 %1 至 %2 位数字。</translation>
    </message>
    <message>
        <source>The same digit all along is guessed first. Choose another PIN.</source>
        <translation>全部相同的数字最先被猜到。请换一个 PIN。</translation>
    </message>
    <message>
        <source>Sequences such as 1234 are easy to guess. Choose another PIN.</source>
        <translation>像 1234 这样的连续数字最先被猜到。请换一个 PIN。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1.</source>
        <translation>PIN 不正确。%1 后可再试。</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again.</source>
        <translation>PIN 不正确。请再试。</translation>
    </message>
    <message>
        <source>After wrong PINs this user has to wait: %1.</source>
        <translation>PIN 输错后该用户须等待：%1。</translation>
    </message>
    <message>
        <source>%1 PINs cannot be checked until then: only operators can work.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1 在此之前无法核对 PIN：只有操作员可以工作。</translation>
    </message>
    <message>
        <source>A PIN for the level Service has %1 to %2 digits.</source>
        <translation>“维护”级的 PIN 为 %1 至 %2 位数字。</translation>
    </message>
</context>
<context>
    <name>AlarmCatalogue</name>
    <message>
        <source>%1 %2</source>
        <comment>whole sentences: cause and what to do</comment>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>Axis does not follow</source>
        <translation>跟随误差过大</translation>
    </message>
    <message>
        <source>The axis does not keep up with its command.</source>
        <translation>轴跟不上指令。</translation>
    </message>
    <message>
        <source>Look for a jam, then reset the fault and home.</source>
        <translation>请检查是否卡阻，然后复位故障并回零。</translation>
    </message>
    <message>
        <source>Table damaged</source>
        <translation>数据表损坏</translation>
    </message>
    <message>
        <source>The table in the controller is damaged.</source>
        <translation>控制器中的数据表已损坏。</translation>
    </message>
    <message>
        <source>Reset the fault and download the recipe again.</source>
        <translation>请复位故障并重新下载配方。</translation>
    </message>
    <message>
        <source>No index mark</source>
        <translation>没有零位标记</translation>
    </message>
    <message>
        <source>No index mark was found while homing.</source>
        <translation>回零时没有找到零位标记。</translation>
    </message>
    <message>
        <source>Check drive and index sensor, then reset the fault.</source>
        <translation>请检查驱动器和零位传感器，然后复位故障。</translation>
    </message>
    <message>
        <source>Largest force reached</source>
        <translation>达到最大力</translation>
    </message>
    <message>
        <source>The press reached its largest force, stopped and went back.</source>
        <translation>压装力达到上限，压机已停止并返回。</translation>
    </message>
    <message>
        <source>Look for a jam or a wrong work piece, then reset the fault.</source>
        <translation>请检查是否卡阻或工件有误，然后复位故障。</translation>
    </message>
    <message>
        <source>Touched too early</source>
        <translation>过早接触工件</translation>
    </message>
    <message>
        <source>The press met something on its way down.</source>
        <translation>压头在快进途中碰到物体。</translation>
    </message>
    <message>
        <source>Check the work piece and the approach position, then reset the fault.</source>
        <translation>请检查工件和快进位置，然后复位故障。</translation>
    </message>
    <message>
        <source>No work piece</source>
        <translation>没有工件</translation>
    </message>
    <message>
        <source>The press did not feel a work piece.</source>
        <translation>压机没有探测到工件。</translation>
    </message>
    <message>
        <source>Put one in or check where it must be touched, then reset the fault.</source>
        <translation>请放入工件或检查探测位置，然后复位故障。</translation>
    </message>
    <message>
        <source>Master too fast</source>
        <translation>主轴过快</translation>
    </message>
    <message>
        <source>The axis cannot follow this master: too many pulses.</source>
        <translation>从轴跟不上主轴：脉冲频率过高。</translation>
    </message>
    <message>
        <source>Lower the master speed, then reset the fault.</source>
        <translation>请降低主轴速度，然后复位故障。</translation>
    </message>
    <message>
        <source>Unknown fault</source>
        <translation>未知故障</translation>
    </message>
    <message>
        <source>The controller tells of a fault that this panel does not know.</source>
        <translation>控制器报告了本面板不认识的故障。</translation>
    </message>
    <message>
        <source>Update the panel. Until then look at the machine before you reset the fault.</source>
        <translation>请更新面板。在此之前，复位故障前请先查看机器。</translation>
    </message>
    <message>
        <source>Panel not heard</source>
        <translation>收不到面板信号</translation>
    </message>
    <message>
        <source>The controller had not heard the panel for a while.</source>
        <translation>控制器有一段时间没有收到面板的信号。</translation>
    </message>
    <message>
        <source>Check the cable.</source>
        <translation>请检查电缆。</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>The controller does not know where the axis stands.</source>
        <translation>控制器不知道轴的位置。</translation>
    </message>
    <message>
        <source>Nothing needs to be done: Start homes first.</source>
        <translation>无需处理：启动时会先回零。</translation>
    </message>
    <message>
        <source>Saved copy damaged</source>
        <translation>保存的副本损坏</translation>
    </message>
    <message>
        <source>One of the two saved copies in the controller is damaged.</source>
        <translation>控制器中两份保存的副本有一份已损坏。</translation>
    </message>
    <message>
        <source>Save the program again.</source>
        <translation>请重新保存程序。</translation>
    </message>
    <message>
        <source>Clock not set</source>
        <translation>时钟未设定</translation>
    </message>
    <message>
        <source>The controller has no time of day since it was switched on.</source>
        <translation>控制器上电后还没有当前时间。</translation>
    </message>
    <message>
        <source>Nothing needs to be done: the panel sets it when it connects.</source>
        <translation>无需处理：面板连接时会设定时钟。</translation>
    </message>
    <message>
        <source>Unknown warning</source>
        <translation>未知警告</translation>
    </message>
    <message>
        <source>The controller tells of a warning that this panel does not know.</source>
        <translation>控制器报告了本面板不认识的警告。</translation>
    </message>
    <message>
        <source>Update the panel.</source>
        <translation>请更新面板。</translation>
    </message>
    <message>
        <source>Marks lost</source>
        <translation>色标丢失</translation>
    </message>
    <message>
        <source>The marks on the film were lost and the run was ended.</source>
        <translation>薄膜上的色标丢失，运行已结束。</translation>
    </message>
    <message>
        <source>Check film and mark sensor, then start again.</source>
        <translation>请检查薄膜和色标传感器，然后重新启动。</translation>
    </message>
    <message>
        <source>Wrong mark distance</source>
        <translation>色标间距不符</translation>
    </message>
    <message>
        <source>The marks on the film are not one bag length apart, so the run was ended.</source>
        <translation>薄膜上色标的间距不是一个袋长，运行已结束。</translation>
    </message>
    <message>
        <source>Load the right film or teach its marks under Service.</source>
        <translation>请装上正确的薄膜，或在“维护”中示教色标。</translation>
    </message>
    <message>
        <source>Correction at its limit</source>
        <translation>修正达到限值</translation>
    </message>
    <message>
        <source>The cuts could not follow the marks within the limits, so the run was ended.</source>
        <translation>切断在限值内跟不上色标，运行已结束。</translation>
    </message>
    <message>
        <source>Check the film&apos;s tension and whether it slips, then start again.</source>
        <translation>请检查薄膜张力以及是否打滑，然后重新启动。</translation>
    </message>
    <message>
        <source>Product too long</source>
        <translation>产品过长</translation>
    </message>
    <message>
        <source>A product is too long for the bag, so the run was ended.</source>
        <translation>有产品长于袋长，运行已结束。</translation>
    </message>
    <message>
        <source>Take it out or set a longer bag, then start again.</source>
        <translation>请取出该产品或设定更长的袋长，然后重新启动。</translation>
    </message>
    <message>
        <source>Too many cuts left out</source>
        <translation>略过的切断过多</translation>
    </message>
    <message>
        <source>Products lay across the knife&apos;s path several times in a row, so the run was ended.</source>
        <translation>产品连续多次横在切刀处，运行已结束。</translation>
    </message>
    <message>
        <source>Put the products in order, then start again.</source>
        <translation>请理顺产品，然后重新启动。</translation>
    </message>
    <message>
        <source>Port missing</source>
        <translation>端口不存在</translation>
    </message>
    <message>
        <source>The port to the controller is not there.</source>
        <translation>连接控制器的端口不存在。</translation>
    </message>
    <message>
        <source>Plug the adapter in, or choose another port in the settings.</source>
        <translation>请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>No response on the port to the controller.</source>
        <translation>连接控制器的端口上无应答。</translation>
    </message>
    <message>
        <source>Check cable, power, baud rate, parity and unit number.</source>
        <translation>请检查电缆、电源、波特率、校验和站号。</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>The connection to the controller was there and broke off.</source>
        <translation>与控制器的连接曾经建立，后来中断。</translation>
    </message>
    <message>
        <source>Check the cable and the controller&apos;s power; the panel reconnects by itself.</source>
        <translation>请检查电缆和控制器电源；面板会自动重新连接。</translation>
    </message>
    <message>
        <source>Wrong device</source>
        <translation>设备不符</translation>
    </message>
    <message>
        <source>Unknown state</source>
        <translation>状态未知</translation>
    </message>
    <message>
        <source>What answers on the port is not a controller that this panel knows.</source>
        <translation>端口上应答的不是本面板认识的控制器。</translation>
    </message>
    <message>
        <source>Choose another port or unit number, or update the older of the two.</source>
        <translation>请选择其他端口或站号，或更新两者中较旧的一方。</translation>
    </message>
    <message>
        <source>Port cannot be used</source>
        <translation>端口不可用</translation>
    </message>
    <message>
        <source>The port to the controller is there and cannot be used.</source>
        <translation>连接控制器的端口存在，但无法使用。</translation>
    </message>
    <message>
        <source>Close the program that uses it, or choose another port or other settings.</source>
        <translation>请关闭占用端口的程序，或选择其他端口或其他参数。</translation>
    </message>
    <message>
        <source>Simulated controller missing</source>
        <translation>仿真控制器缺失</translation>
    </message>
    <message>
        <source>The simulated controller was not found or has ended.</source>
        <translation>没有找到仿真控制器，或仿真控制器已退出。</translation>
    </message>
    <message>
        <source>Install it, or choose a real port in the settings.</source>
        <translation>请安装它，或在设置中选择实际端口。</translation>
    </message>
    <message>
        <source>Memory replaced by its copy</source>
        <translation>存储已换用副本</translation>
    </message>
    <message>
        <source>Look whether the newest recipes are there. If it comes again, replace the disk.</source>
        <translation>请检查最新的配方是否还在。如再次出现，请更换磁盘。</translation>
    </message>
    <message>
        <source>Memory lost</source>
        <translation>存储丢失</translation>
    </message>
    <message>
        <source>Restore a backup if there is one. If it comes again, replace the disk.</source>
        <translation>如有备份请恢复。如再次出现，请更换磁盘。</translation>
    </message>
    <message>
        <source>Memory not opened</source>
        <translation>存储无法打开</translation>
    </message>
    <message>
        <source>The panel cannot open its memory: nothing is kept over a restart.</source>
        <translation>面板无法打开存储：重启后不会保留任何内容。</translation>
    </message>
    <message>
        <source>Read the detail, put it right and start the panel again.</source>
        <translation>请查看详情，排除原因后重新启动面板。</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>There is no room left on the panel&apos;s disk: nothing new is kept.</source>
        <translation>面板磁盘已无空间：新内容无法保存。</translation>
    </message>
    <message>
        <source>Make room on the disk. What was kept before is not lost.</source>
        <translation>请腾出磁盘空间。先前保存的内容没有丢失。</translation>
    </message>
    <message>
        <source>Disk write-protected</source>
        <translation>磁盘写保护</translation>
    </message>
    <message>
        <source>The panel may not write to its disk: nothing new is kept.</source>
        <translation>面板不能写入磁盘：新内容无法保存。</translation>
    </message>
    <message>
        <source>Remove the write protection. If the disk protects itself, replace it.</source>
        <translation>请解除写保护。如磁盘自行写保护，请更换。</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>未能保存</translation>
    </message>
    <message>
        <source>Something could not be kept in the panel&apos;s memory.</source>
        <translation>有内容未能保存到面板的存储中。</translation>
    </message>
    <message>
        <source>Read the detail and try again. If it comes again, start the panel again.</source>
        <translation>请查看详情并重试。如再次出现，请重新启动面板。</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>配方文件</translation>
    </message>
    <message>
        <source>The last recipe could not be read or not be kept.</source>
        <translation>最近的配方无法读取或无法保存。</translation>
    </message>
    <message>
        <source>Read the detail; check the recipe before you download it.</source>
        <translation>请查看详情；下载前请核对配方。</translation>
    </message>
    <message>
        <source>Settings not kept</source>
        <translation>设置未保存</translation>
    </message>
    <message>
        <source>The settings cannot be written: they hold until the panel is switched off.</source>
        <translation>设置无法写入：只在面板关机前有效。</translation>
    </message>
    <message>
        <source>Check whether the disk is full or write-protected.</source>
        <translation>请检查磁盘是否已满或写保护。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was damaged or missing. It goes on with its last good copy.</source>
        <translation>面板的存储已损坏或丢失，现使用最近的完好副本。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was damaged or missing and there was no copy. A new, empty database was created.</source>
        <translation>面板的存储已损坏或丢失且没有副本，已重新开始。</translation>
    </message>
    <message>
        <source>Users and PINs lost</source>
        <translation>用户和 PIN 丢失</translation>
    </message>
    <message>
        <source>The users were lost with the panel&apos;s memory: only operators can work.</source>
        <translation>用户随面板的存储一起丢失：只有操作员可以工作。</translation>
    </message>
    <message>
        <source>Read the detail: it names the file to delete. Then restore a backup.</source>
        <translation>请阅读详情：其中写明要删除的文件。然后恢复备份。</translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>Alarm of a newer version</source>
        <translation>较新版本的报警</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>激活，已确认</translation>
    </message>
    <message>
        <source>End unknown, acknowledged</source>
        <translation>结束时间未知，已确认</translation>
    </message>
    <message>
        <source>Gone, acknowledged</source>
        <translation>已恢复，已确认</translation>
    </message>
    <message>
        <source>Active, not acknowledged</source>
        <translation>激活，未确认</translation>
    </message>
    <message>
        <source>End unknown, not acknowledged</source>
        <translation>结束时间未知，未确认</translation>
    </message>
    <message>
        <source>Gone, not acknowledged</source>
        <translation>已恢复，未确认</translation>
    </message>
    <message>
        <source>Active, shelved</source>
        <translation>激活，已搁置</translation>
    </message>
    <message>
        <source>End unknown, shelved</source>
        <translation>结束时间未知，已搁置</translation>
    </message>
    <message>
        <source>Gone, shelved</source>
        <translation>已恢复，已搁置</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>激活</translation>
    </message>
    <message>
        <source>End unknown</source>
        <translation>结束时间未知</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>到 %1</translation>
    </message>
</context>
<context>
    <name>AuditWords</name>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1 (reason %2)</source>
        <comment>refused (reason 7)</comment>
        <translation>%1（原因 %2）</translation>
    </message>
    <message>
        <source>nobody logged in</source>
        <translation>无人登录</translation>
    </message>
    <message>
        <source>Row %1 is not as it was written: the trail was altered there.</source>
        <translation>第 %1 行与写入时不同：记录在此处被改动。</translation>
    </message>
    <message>
        <source>Row %1 is missing: the trail was altered there.</source>
        <translation>缺少第 %1 行：记录在此处被改动。</translation>
    </message>
    <message>
        <source>Row %1 and what followed it are missing at the end.</source>
        <translation>末尾缺少第 %1 行及其后的各行。</translation>
    </message>
    <message>
        <source>Checked: unbroken, %1 rows.</source>
        <translation>已检查：链完整，共 %1 行。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Wizards</source>
        <translation>向导</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Users and logins</source>
        <translation>用户和登录</translation>
    </message>
    <message>
        <source>The trail itself</source>
        <translation>记录本身</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop at once</source>
        <translation>立即停止</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Fault reset</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Saved in the controller</source>
        <translation>已存入控制器</translation>
    </message>
    <message>
        <source>Marks measured</source>
        <translation>测量色标</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
    <message>
        <source>Value of the program</source>
        <translation>程序数值</translation>
    </message>
    <message>
        <source>Parameter written</source>
        <translation>写入参数</translation>
    </message>
    <message>
        <source>Mark sensor measured</source>
        <translation>测定色标传感器</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Logout</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Logout by itself</source>
        <translation>自动退出</translation>
    </message>
    <message>
        <source>User added</source>
        <translation>添加用户</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>新 PIN</translation>
    </message>
    <message>
        <source>Level of a user</source>
        <translation>用户级别</translation>
    </message>
    <message>
        <source>User removed</source>
        <translation>删除用户</translation>
    </message>
    <message>
        <source>Rows were lost</source>
        <translation>丢失若干行</translation>
    </message>
    <message>
        <source>Oldest rows dropped</source>
        <translation>删去最旧的行</translation>
    </message>
    <message>
        <source>language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>bag tolerance, mm</source>
        <translation>袋长公差，mm</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>minutes until logout</source>
        <translation>自动退出分钟数</translation>
    </message>
    <message>
        <source>operators log in</source>
        <translation>操作员须登录</translation>
    </message>
    <message>
        <source>faults of the simulated line</source>
        <translation>模拟线路的故障</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>not sent: no connection</source>
        <translation>未发送：没有连接</translation>
    </message>
    <message>
        <source>the controller did not get it</source>
        <translation>控制器未收到</translation>
    </message>
    <message>
        <source>not known: no proof came back</source>
        <translation>不清楚：没有得到确认</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>已撤回</translation>
    </message>
    <message>
        <source>canceled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>wrong PIN</source>
        <translation>PIN 错误</translation>
    </message>
    <message>
        <source>had to wait after wrong PINs</source>
        <translation>PIN 输错后须等待</translation>
    </message>
    <message>
        <source>written, but the cuts are off</source>
        <translation>已写入，但切断位置仍有偏差</translation>
    </message>
    <message>
        <source>Backup and restore</source>
        <translation>备份与恢复</translation>
    </message>
    <message>
        <source>Backup made</source>
        <translation>已备份</translation>
    </message>
    <message>
        <source>Replaced by a backup</source>
        <translation>被备份替换</translation>
    </message>
    <message>
        <source>Restored from a backup</source>
        <translation>从备份恢复</translation>
    </message>
    <message>
        <source>Homing ended</source>
        <translation>回零结束</translation>
    </message>
    <message>
        <source>Jog forward</source>
        <translation>正向点动</translation>
    </message>
    <message>
        <source>Jog in reverse</source>
        <translation>反向点动</translation>
    </message>
    <message>
        <source>Jog ended</source>
        <translation>点动结束</translation>
    </message>
    <message>
        <source>key let go</source>
        <translation>按键已松开</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>light, dark or high contrast</source>
        <translation>浅色、深色或高对比度</translation>
    </message>
    <message>
        <source>keys for gloves</source>
        <translation>手套按键</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>New recipe</source>
        <translation>新建配方</translation>
    </message>
    <message>
        <source>Recipe saved</source>
        <translation>配方已保存</translation>
    </message>
    <message>
        <source>Recipe renamed</source>
        <translation>配方已改名</translation>
    </message>
    <message>
        <source>Recipe deleted</source>
        <translation>配方已删除</translation>
    </message>
    <message>
        <source>Recipe brought back</source>
        <translation>配方已恢复</translation>
    </message>
    <message>
        <source>The newest row was not known</source>
        <translation>最新一行曾无从得知</translation>
    </message>
    <message>
        <source>Unbroken up to row %1, but the file that knows the newest row is gone: rows may be missing at the end.</source>
        <translation>到第 %1 行为止完整，但记录最新一行的文件已不存在：末尾可能缺少记录。</translation>
    </message>
    <message>
        <source>Checked: unbroken, %1 rows; rows may have been lost once, see there.</source>
        <translation>已检查：链完整，共 %1 行；曾经可能丢失过记录，见相应行。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory</source>
        <translation>面板的存储</translation>
    </message>
    <message>
        <source>Replaced by its copy</source>
        <translation>已由副本替换</translation>
    </message>
    <message>
        <source>Lost, began empty</source>
        <translation>已丢失，从空白开始</translation>
    </message>
</context>
<context>
    <name>BackupErrorText</name>
    <message>
        <source>The file %1 cannot be read: %2. Nothing was changed.</source>
        <translation>无法读取文件 %1：%2。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 is no backup of CamPanel. Nothing was changed.</source>
        <translation>%1 不是 CamPanel 的备份。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 was made by the newer CamPanel %2. Install that version first. Nothing was changed.</source>
        <translation>%1 由更新的 CamPanel %2 生成。请先安装该版本。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 is damaged (%2). Take another backup. Nothing was changed.</source>
        <translation>%1 已损坏（%2）。请使用其他备份。没有任何更改。</translation>
    </message>
    <message>
        <source>The backup cannot be unpacked: %1. Make room on this panel. Nothing was changed.</source>
        <translation>无法解开备份：%1。请在本面板上腾出空间。没有任何更改。</translation>
    </message>
    <message>
        <source>it needs %1 MB and %2 MB are free</source>
        <translation>需要 %1 MB，剩余 %2 MB</translation>
    </message>
</context>
<context>
    <name>ConnectionSentences</name>
    <message>
        <source>Connected to the simulated controller.</source>
        <translation>已连接到仿真控制器。</translation>
    </message>
    <message>
        <source>Connected to the controller on %1.</source>
        <translation>已通过 %1 连接到控制器。</translation>
    </message>
    <message>
        <source>Asking the controller on %1 who it is …</source>
        <translation>正在询问 %1 上控制器的身份…</translation>
    </message>
    <message>
        <source>Looking for the port %1 …</source>
        <translation>正在查找端口 %1…</translation>
    </message>
    <message>
        <source>The simulated controller was not found at %1. Install it, or choose a real port in the settings.</source>
        <translation>在 %1 没有找到仿真控制器。请安装它，或在设置中选择实际端口。</translation>
    </message>
    <message>
        <source>The simulated controller has ended and is being started again.</source>
        <translation>仿真控制器已退出，正在重新启动。</translation>
    </message>
    <message>
        <source>The simulated controller has ended and is being started again. It wrote: %1</source>
        <translation>仿真控制器已退出，正在重新启动。它的输出：%1</translation>
    </message>
    <message>
        <source>The simulated controller is starting …</source>
        <translation>仿真控制器正在启动…</translation>
    </message>
    <message>
        <source>There is no port %1. Plug the adapter in, or choose another port in the settings.</source>
        <translation>没有端口 %1。请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>The port %1 is in use by another program. Close that program, or choose another port.</source>
        <translation>端口 %1 正被其他程序占用。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>This user may not use the port %1. Add the user to the group &quot;%2&quot; and log in again.</source>
        <translation>当前用户无权使用端口 %1。请将用户加入“%2”组并重新登录。</translation>
    </message>
    <message>
        <source>%1 is not a serial port. Choose another port in the settings.</source>
        <translation>%1 不是串口。请在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>The port %1 cannot be set up: %2. Choose other settings.</source>
        <translation>端口 %1 无法设置：%2。请选择其他参数。</translation>
    </message>
    <message>
        <source>The port %1 has gone. Check the adapter; the panel keeps trying.</source>
        <translation>端口 %1 已不存在。请检查适配器，面板会继续重试。</translation>
    </message>
    <message>
        <source>No response on %1. Check cable, power, baud rate, parity and unit number.</source>
        <translation>%1 上没有应答。请检查电缆、电源、波特率、校验和站号。</translation>
    </message>
    <message>
        <source>Only garbage comes from %1. Check baud rate, parity and stop bits.</source>
        <translation>%1 收到的都是乱码。请检查波特率、校验和停止位。</translation>
    </message>
    <message>
        <source>Answers on %1 belong to other questions. Is another master on the line?</source>
        <translation>%1 上的应答不属于本机的请求。线路上是否有其他主站？</translation>
    </message>
    <message>
        <source>The device on %1 refuses the question (Modbus exception %2). It may not be a CamPanel controller.</source>
        <translation>%1 上的设备拒绝了请求（Modbus 异常 %2）。它可能不是 CamPanel 控制器。</translation>
    </message>
    <message>
        <source>The device on %1 is not a CamPanel controller. Choose another port or unit number.</source>
        <translation>%1 上的设备不是 CamPanel 控制器。请选择其他端口或站号。</translation>
    </message>
    <message>
        <source>The controller on %1 has register map version %2, this panel needs version %3. Update the older of the two.</source>
        <translation>%1 上控制器的寄存器表版本为 %2，本面板需要版本 %3。请升级较旧的一方。</translation>
    </message>
    <message>
        <source>The controller on %1 reports an impossible value: %2 is %3. Correct its firmware.</source>
        <translation>%1 上的控制器报告了不可能的值：%2 为 %3。请更正其固件。</translation>
    </message>
    <message>
        <source>The controller on %1 lacks registers that this panel needs. Update its firmware.</source>
        <translation>%1 上的控制器缺少本面板需要的寄存器。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller did not receive the command. Try again.</source>
        <translation>控制器没有收到命令。请重试。</translation>
    </message>
    <message>
        <source>It is not known whether the controller received the command. Look at the machine before trying again.</source>
        <translation>无法确定控制器是否收到命令。重试前请先查看机器。</translation>
    </message>
    <message>
        <source>The controller kept another value than was written. Try again.</source>
        <translation>控制器保存的值与写入的不同。请重试。</translation>
    </message>
    <message>
        <source>The value is outside the limits of the controller: %1</source>
        <translation>该值超出控制器的范围：%1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Reset fault</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <comment>%1: command, %2: whole sentence</comment>
        <translation>%1被拒绝：%2</translation>
    </message>
    <message>
        <source>%1 was not sent: there is no connection to the controller.</source>
        <translation>%1未发送：没有连接到控制器。</translation>
    </message>
    <message>
        <source>%1 did not reach the controller. Try again.</source>
        <translation>%1没有到达控制器。请重试。</translation>
    </message>
    <message>
        <source>%1 was sent, but no answer came. Look at the machine before trying again.</source>
        <translation>%1已发送，但没有应答。重试前请先查看机器。</translation>
    </message>
    <message>
        <source>Not downloaded: there is no connection to the controller.</source>
        <translation>未下载：没有连接到控制器。</translation>
    </message>
    <message>
        <source>Not downloaded: another download is under way.</source>
        <translation>未下载：另一个下载正在进行。</translation>
    </message>
    <message>
        <source>The connection is lost; the download goes on when it is back.</source>
        <translation>连接中断，恢复后继续下载。</translation>
    </message>
    <message>
        <source>Sending the table …</source>
        <translation>正在发送数据表…</translation>
    </message>
    <message>
        <source>The controller checks the table …</source>
        <translation>控制器正在检查数据表…</translation>
    </message>
    <message>
        <source>Checked. Becomes active at the end of the cycle.</source>
        <translation>检查通过，将在本周期结束时生效。</translation>
    </message>
    <message>
        <source>Canceled. The controller&apos;s program is unchanged.</source>
        <translation>已取消。控制器的程序没有改变。</translation>
    </message>
    <message>
        <source>The download failed and the controller&apos;s program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>下载失败，控制器的程序没有改变。%1</translation>
    </message>
    <message>
        <source>The table needs %1 registers, the controller holds %2. Use fewer slices per ramp.</source>
        <translation>数据表需要 %1 个寄存器，控制器只有 %2 个。请减少每段斜坡的分段数。</translation>
    </message>
    <message>
        <source>This controller cannot execute this kind of program. Update its firmware.</source>
        <translation>该控制器不能执行这类程序。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller refused the table, its program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>控制器拒绝了数据表，其程序没有改变。%1</translation>
    </message>
    <message>
        <source>The controller received other bytes than were sent; its program is unchanged. Download again.</source>
        <translation>控制器收到的数据与发送的不同，其程序没有改变。请重新下载。</translation>
    </message>
    <message>
        <source>The controller did not apply the table, its program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>控制器没有启用数据表，其程序没有改变。%1</translation>
    </message>
    <message>
        <source>The change was withdrawn before it became active; the controller&apos;s program is unchanged.</source>
        <translation>更改在生效前被撤回，控制器的程序没有改变。</translation>
    </message>
    <message>
        <source>%1 was not changed: there is no connection to the controller.</source>
        <translation>%1未更改：没有连接到控制器。</translation>
    </message>
    <message>
        <source>%1 was not changed: %2</source>
        <comment>%2: whole sentence</comment>
        <translation>%1未更改：%2</translation>
    </message>
    <message>
        <source>%1 was sent, but no proof came back. Look at the machine before trying again.</source>
        <translation>%1已发送，但没有得到确认。请先查看机器，再重试。</translation>
    </message>
    <message>
        <source>The link doctor has the ports. The connection comes back when it has ended.</source>
        <translation>线路诊断正在使用端口，结束后连接会恢复。</translation>
    </message>
    <message>
        <source>No connection since %1. The panel asks the simulated controller on %2 four times a second and reconnects by itself.</source>
        <translation>自 %1 起没有连接。面板每秒四次询问 %2 上的模拟控制器，并会自动重新连接。</translation>
    </message>
    <message>
        <source>No connection since %1: the port %2 is gone. Plug the adapter in again; the panel looks for it four times a second, under any name, and reconnects by itself.</source>
        <translation>自 %1 起没有连接：端口 %2 已消失。请重新插上适配器；面板每秒四次查找它（无论端口叫什么名字），并会自动重新连接。</translation>
    </message>
    <message>
        <source>No connection since %1: nobody answers on %2. Check the cable and the controller&apos;s power; the panel keeps asking and reconnects by itself.</source>
        <translation>自 %1 起没有连接：%2 上无人应答。请检查电缆和控制器电源；面板会不断询问并自动重新连接。</translation>
    </message>
    <message>
        <source>Measure the marks</source>
        <translation>测量色标</translation>
    </message>
    <message>
        <source>No controller is chosen. Choose one on the Settings page, under Connection.</source>
        <translation>未选择控制器。请在“设置”页的“通信”中选择。</translation>
    </message>
    <message>
        <source>The controller has this program.</source>
        <translation>控制器中已是此程序。</translation>
    </message>
</context>
<context>
    <name>ControllerSentences</name>
    <message>
        <source>No program</source>
        <translation>无程序</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>正在停止</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>回零中</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>The controller does not know this command. Update its firmware.</source>
        <translation>控制器不认识此命令。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>控制器没有程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The machine is already moving.</source>
        <translation>机器已经在运动。</translation>
    </message>
    <message>
        <source>The machine is not running.</source>
        <translation>机器没有运行。</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>控制器处于故障状态。请先复位故障。</translation>
    </message>
    <message>
        <source>This is only possible at standstill. Stop the machine first.</source>
        <translation>此操作只能在静止时进行。请先停机。</translation>
    </message>
    <message>
        <source>The controller holds no checked table. Download again.</source>
        <translation>控制器没有通过检查的数据表。请重新下载。</translation>
    </message>
    <message>
        <source>Another download came in between. Download again.</source>
        <translation>期间有另一次下载。请重新下载。</translation>
    </message>
    <message>
        <source>The controller holds other bytes. Download again.</source>
        <translation>控制器中的数据不同。请重新下载。</translation>
    </message>
    <message>
        <source>No change is waiting.</source>
        <translation>没有等待生效的更改。</translation>
    </message>
    <message>
        <source>The controller&apos;s flash could not be written; what was saved before is unchanged.</source>
        <translation>控制器闪存写入失败，之前保存的内容没有改变。</translation>
    </message>
    <message>
        <source>There is no fault to reset.</source>
        <translation>没有需要复位的故障。</translation>
    </message>
    <message>
        <source>The controller does not accept this value. Update the older of panel and controller.</source>
        <translation>控制器不接受此值。请升级面板和控制器中较旧的一方。</translation>
    </message>
    <message>
        <source>The cause of the fault is still there. Remove it first.</source>
        <translation>故障原因仍然存在。请先排除。</translation>
    </message>
    <message>
        <source>The controller does not hear the panel. Check the cable.</source>
        <translation>控制器收不到面板的信号。请检查电缆。</translation>
    </message>
    <message>
        <source>The controller gives a reason that this panel does not know (%1).</source>
        <translation>控制器给出了本面板不认识的原因（%1）。</translation>
    </message>
    <message>
        <source>Parts of the table did not arrive. Download again.</source>
        <translation>数据表有部分没有到达。请重新下载。</translation>
    </message>
    <message>
        <source>Panel and controller do not match. Update the older of the two.</source>
        <translation>面板与控制器不匹配。请升级较旧的一方。</translation>
    </message>
    <message>
        <source>Value %1 of the table&apos;s header is outside the controller&apos;s limits.</source>
        <translation>数据表头的第 %1 个值超出控制器的范围。</translation>
    </message>
    <message>
        <source>Row %1 of the table is outside the range of the controller&apos;s timer. Lower the rate.</source>
        <translation>数据表第 %1 行超出控制器定时器的范围。请降低速率。</translation>
    </message>
    <message>
        <source>The rows do not add up to the announced pulses and time. Download again.</source>
        <translation>各行之和与声明的脉冲数和时间不符。请重新下载。</translation>
    </message>
    <message>
        <source>An earlier change is still waiting for the end of the cycle. Cancel it first.</source>
        <translation>之前的更改仍在等待周期结束。请先取消它。</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>快进</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>探测</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>压装</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保压</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Stopped outside the tolerance</source>
        <translation>终点位置超差</translation>
    </message>
    <message>
        <source>Force too low</source>
        <translation>压装力过小</translation>
    </message>
    <message>
        <source>Force too high</source>
        <translation>压装力过大</translation>
    </message>
    <message>
        <source>Touched too early</source>
        <translation>过早接触工件</translation>
    </message>
    <message>
        <source>Never touched</source>
        <translation>未接触到工件</translation>
    </message>
    <message>
        <source>Largest force reached</source>
        <translation>达到最大力</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>中途停止</translation>
    </message>
    <message>
        <source>The data of the machine change only at standstill. Stop the machine first.</source>
        <translation>机器数据只能在静止时更改。请先停机。</translation>
    </message>
    <message>
        <source>Too many bags lie between mark sensor and knife. Set a longer bag, move the sensor nearer, or switch mark tracking off under Service.</source>
        <translation>色标传感器与切刀之间的袋数过多。请设定更长的袋长、移近传感器，或在“维护”中关闭色标跟踪。</translation>
    </message>
    <message>
        <source>The window for the marks is wider than half a bag. Make it narrower under Service.</source>
        <translation>色标窗口宽于半个袋长。请在“维护”中缩小窗口。</translation>
    </message>
    <message>
        <source>Knife and film move together for so long that no time is left to correct the film. Change k1 to k4.</source>
        <translation>切刀与薄膜同步的时间过长，没有时间修正薄膜。请更改 k1 至 k4。</translation>
    </message>
    <message>
        <source>The product eye is too near or too far to decide in time. Check its distance under Service.</source>
        <translation>产品光电离切刀过近或过远，来不及判断。请在“维护”中检查其距离。</translation>
    </message>
    <message>
        <source>Marks not followed</source>
        <translation>未跟踪色标</translation>
    </message>
    <message>
        <source>Looking for marks</source>
        <translation>正在寻找色标</translation>
    </message>
    <message>
        <source>Moving the cuts onto the marks</source>
        <translation>正在将切断对准色标</translation>
    </message>
    <message>
        <source>Following the marks</source>
        <translation>正在跟踪色标</translation>
    </message>
    <message>
        <source>A product lay across the knife&apos;s path</source>
        <translation>有产品横在切刀处</translation>
    </message>
    <message>
        <source>A product was longer than the bag</source>
        <translation>有产品长于袋长</translation>
    </message>
    <message>
        <source>A product was missing</source>
        <translation>缺少产品</translation>
    </message>
    <message>
        <source>The film or the infeed would have to run faster than the controller can drive it. Lower the rate.</source>
        <translation>薄膜或进料须快于控制器所能驱动的速度。请降低速率。</translation>
    </message>
    <message>
        <source>Another device on the line writes commands in parts. Check what is connected.</source>
        <translation>线路上另有设备分段写入命令。请检查所连接的设备。</translation>
    </message>
</context>
<context>
    <name>DifferencesText</name>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Speed law</source>
        <translation>速度规律</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>固定输入</translation>
    </message>
    <message>
        <source>Law parameter 2</source>
        <translation>规律参数 2</translation>
    </message>
    <message>
        <source>Law parameter 1</source>
        <translation>规律参数 1</translation>
    </message>
    <message>
        <source>Kind of program</source>
        <translation>程序类型</translation>
    </message>
    <message>
        <source>Displacement law</source>
        <translation>位移规律</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>型值点</translation>
    </message>
    <message numerus="yes">
        <source>%n knot(s)</source>
        <translation>
            <numerusform>%n 个型值点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DoctorSentences</name>
    <message>
        <source>%1 baud, 8%2%3, unit %4</source>
        <comment>parity letter, stop bits</comment>
        <translation>%1 波特，8%2%3，站号 %4</translation>
    </message>
    <message>
        <source>Controller found</source>
        <translation>找到控制器</translation>
    </message>
    <message>
        <source>Controller at another unit number</source>
        <translation>控制器在另一个站号</translation>
    </message>
    <message>
        <source>Controller of another version</source>
        <translation>其他版本的控制器</translation>
    </message>
    <message>
        <source>Another device</source>
        <translation>其他设备</translation>
    </message>
    <message>
        <source>Only garbage</source>
        <translation>只有乱码</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Echo only</source>
        <translation>仅有回波</translation>
    </message>
    <message>
        <source>No such port</source>
        <translation>没有此端口</translation>
    </message>
    <message>
        <source>Not permitted</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>In use by another program</source>
        <translation>被其他程序占用</translation>
    </message>
    <message>
        <source>No serial port</source>
        <translation>不是串口</translation>
    </message>
    <message>
        <source>Settings not possible</source>
        <translation>无法这样设置</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>已拔出</translation>
    </message>
    <message>
        <source>A CamPanel controller with firmware %1 answers.</source>
        <translation>CamPanel 控制器应答，固件版本 %1。</translation>
    </message>
    <message>
        <source>A CamPanel controller answers at unit %1, which is not the one that is set. Use this connection, or set the unit number at the controller.</source>
        <translation>CamPanel 控制器在站号 %1 应答，与设置的站号不同。请使用此连接，或在控制器上修改站号。</translation>
    </message>
    <message>
        <source>A CamPanel controller answers with register map version %1; this panel needs version %2. Update the older of the two.</source>
        <translation>CamPanel 控制器应答，其寄存器表版本为 %1；本面板需要版本 %2。请更新两者中较旧的一方。</translation>
    </message>
    <message>
        <source>A device answers that is no CamPanel controller. Choose another port or unit number.</source>
        <translation>应答的设备不是 CamPanel 控制器。请选择其他端口或站号。</translation>
    </message>
    <message>
        <source>%1 bytes came, but no answer could be read. Baud rate, parity or stop bits differ from the controller&apos;s, or the cable picks up noise. Search for the controller; check shield and ground.</source>
        <translation>收到 %1 个字节，但无法读出应答。波特率、校验或停止位与控制器不同，或者电缆受到干扰。请搜索控制器；检查屏蔽和接地。</translation>
    </message>
    <message>
        <source>Not a single byte comes. Check that the controller has power and that the cable is plugged in at both ends; on RS-232 the transmit and receive wires must be crossed, on RS-485 A and B may be swapped.</source>
        <translation>一个字节也没有收到。请检查控制器是否通电、电缆两端是否插好；RS-232 的收发线必须交叉，RS-485 的 A、B 可能接反。</translation>
    </message>
    <message>
        <source>The adapter returns what the panel sends, and no controller answers. Check that the controller has power, that the cable is plugged in at both ends, and that A and B are not swapped.</source>
        <translation>适配器将面板发送的内容原样返回，没有控制器应答。请检查控制器是否通电、电缆两端是否插好，以及 A、B 线是否接反。</translation>
    </message>
    <message>
        <source>%1 The USB adapter collects bytes for %2 ms before it hands them on, which slows the line down: set its latency timer to 1 ms.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 USB 适配器把字节攒 %2 毫秒才交出，使线路变慢：请把它的延迟定时器设为 1 毫秒。</translation>
    </message>
    <message>
        <source>This port is not there. Plug the adapter in, or choose another port in the settings.</source>
        <translation>此端口不存在。请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>This user may not use the port. Ask the administrator for the right to use it.</source>
        <translation>此用户无权使用该端口。请向管理员申请权限。</translation>
    </message>
    <message>
        <source>This user may not use the port. Add the user to the group &quot;%1&quot; and log in again.</source>
        <translation>此用户无权使用该端口。请把用户加入用户组“%1”并重新登录。</translation>
    </message>
    <message>
        <source>This is no serial port. Choose another port in the settings.</source>
        <translation>这不是串口。请在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>The port cannot be set up like this: %1. Choose other settings.</source>
        <translation>端口无法这样设置：%1。请选择其他设置。</translation>
    </message>
    <message>
        <source>The adapter disappeared while it was asked. Check its plug and cable.</source>
        <translation>询问时适配器消失了。请检查插头和电缆。</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>进程 %1</translation>
    </message>
    <message>
        <source>%1 (process %2)</source>
        <translation>%1（进程 %2）</translation>
    </message>
    <message>
        <source>Another program has this port open. Close that program, or choose another port.</source>
        <translation>另一个程序占用了此端口。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>The port is held by %1. Close that program, or choose another port.</source>
        <translation>端口被 %1 占用。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>%1 of %2, at most %3 min more</source>
        <translation>第 %1 个，共 %2 个，最多还需 %3 分钟</translation>
    </message>
    <message>
        <source>%1 of %2, at most %3 s more</source>
        <translation>第 %1 个，共 %2 个，最多还需 %3 秒</translation>
    </message>
</context>
<context>
    <name>EditorViews</name>
    <message>
        <source>%1 r/min</source>
        <translation>%1 r/min</translation>
    </message>
    <message>
        <source>%1 m/s²</source>
        <translation>%1 m/s²</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>acceleration steps</source>
        <translation>加速度突变</translation>
    </message>
    <message>
        <source>%1 m/s³</source>
        <translation>%1 m/s³</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 m/s² · %3 kHz</source>
        <translation>峰值 %1 r/min · %2 m/s² · %3 kHz</translation>
    </message>
    <message>
        <source>The controller cannot hold the value %1 (%2 to %3). Choose another one.</source>
        <translation>控制器不能存储数值 %1（范围 %2 到 %3）。请选择其他值。</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 m/s² · %3 Nm · %4 kHz</source>
        <translation>峰值 %1 r/min · %2 m/s² · %3 Nm · %4 kHz</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>刚好在限制之内。</translation>
    </message>
    <message>
        <source>Within all limits.</source>
        <translation>在所有限制之内。</translation>
    </message>
    <message>
        <source>Within all limits; the table is being made …</source>
        <translation>在所有限制之内；正在生成表 …</translation>
    </message>
</context>
<context>
    <name>FileErrorText</name>
    <message>
        <source>The recipe file %1 does not exist. Check its name.</source>
        <translation>配方文件 %1 不存在。请检查文件名。</translation>
    </message>
    <message>
        <source>The recipe file %1 cannot be read: %2.</source>
        <translation>配方文件 %1 无法读取：%2。</translation>
    </message>
    <message>
        <source>The recipe could not be saved to %1: %2. The stored recipe is unchanged. Make room there or check the permissions, then save again.</source>
        <translation>配方无法保存到 %1：%2。已存储的配方没有改变。请腾出空间或检查权限，然后重新保存。</translation>
    </message>
    <message>
        <source>The recipe file %1 is damaged at byte %2: %3. Restore it from a copy.</source>
        <translation>配方文件 %1 在第 %2 字节处损坏：%3。请从副本恢复。</translation>
    </message>
    <message>
        <source>%1 is not a CamPanel recipe: the key &quot;format&quot; must be &quot;campanel-recipe&quot;.</source>
        <translation>%1 不是 CamPanel 配方：键 &quot;format&quot; 必须为 &quot;campanel-recipe&quot;。</translation>
    </message>
    <message>
        <source>The recipe file %1 has format version %2, this program reads version %3. Update the program.</source>
        <translation>配方文件 %1 的格式版本为 %2，本程序读取版本 %3。请升级程序。</translation>
    </message>
    <message>
        <source>In the recipe file %1 the key %2 is not known. Correct or remove it.</source>
        <translation>配方文件 %1 中的键 %2 无法识别。请更正或删除。</translation>
    </message>
    <message>
        <source>In the recipe file %1 the key %2 is missing. Add it.</source>
        <translation>配方文件 %1 中缺少键 %2。请补上。</translation>
    </message>
    <message>
        <source>In the recipe file %1 %2 must be %3.</source>
        <translation>配方文件 %1 中的 %2 必须是%3。</translation>
    </message>
    <message>
        <source>In the recipe file %1 %2 is %3; enter %4.</source>
        <translation>配方文件 %1 中的 %2 为 %3，请输入 %4。</translation>
    </message>
    <message>
        <source>In the recipe file %1 %2 is &quot;%3&quot;; choose one of: %4.</source>
        <translation>配方文件 %1 中的 %2 为“%3”，请从以下选择：%4。</translation>
    </message>
    <message>
        <source>In the recipe file %1 %2 is longer than %3 bytes. Shorten it.</source>
        <translation>配方文件 %1 中的 %2 超过 %3 字节。请缩短。</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>an object in braces</source>
        <translation>花括号中的对象</translation>
    </message>
    <message>
        <source>a list of two different ones of bag_length_mm, rate_bags_per_min, base_speed_mm_per_s, film_speed_mm_per_s</source>
        <translation>由 bag_length_mm、rate_bags_per_min、base_speed_mm_per_s、film_speed_mm_per_s 中两个不同项组成的列表</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 到 %2 %3</translation>
    </message>
    <message>
        <source>pairs of master angle and slave position</source>
        <translation>主轴角度与从轴位置的数对</translation>
    </message>
    <message>
        <source>the header master_deg,slave_mm</source>
        <translation>表头 master_deg,slave_mm</translation>
    </message>
    <message>
        <source>two values, as in the header</source>
        <translation>与表头一致的两个值</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>用小数点的数字</translation>
    </message>
    <message>
        <source>a number with a decimal comma</source>
        <translation>用小数逗号的数字</translation>
    </message>
    <message>
        <source>at least one line of values</source>
        <translation>至少一行数据</translation>
    </message>
    <message>
        <source>The file %1 is not text in UTF-8. Save it as CSV in UTF-8.</source>
        <translation>文件 %1 不是 UTF-8 文本。请另存为 UTF-8 编码的 CSV。</translation>
    </message>
    <message>
        <source>%1, line %2: expected %3, found &quot;%4&quot;.</source>
        <translation>%1 第 %2 行：应为%3，实际为“%4”。</translation>
    </message>
    <message>
        <source>The file %1 does not exist. Check its name.</source>
        <translation>文件 %1 不存在。请检查文件名。</translation>
    </message>
    <message>
        <source>The file %1 cannot be written: %2.</source>
        <translation>文件 %1 无法写入：%2。</translation>
    </message>
    <message>
        <source>The file %1 cannot be read: %2.</source>
        <translation>文件 %1 无法读取：%2。</translation>
    </message>
    <message>
        <source>This panel</source>
        <translation>本面板</translation>
    </message>
    <message>
        <source>%1 Make room there, unlock the stick or choose another place.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 请在该处腾出空间、解除 U 盘的写保护，或选择其他位置。</translation>
    </message>
    <message>
        <source>In the recipe file %1 the key %2 occurs twice. Remove one of them.</source>
        <translation>配方文件 %1 中的键 %2 出现了两次。请删除其中一个。</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>it is larger than 1 MB</source>
        <translation>大于 1 MB</translation>
    </message>
</context>
<context>
    <name>FrameWords</name>
    <message>
        <source>Sent</source>
        <translation>已发送</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>被控制器拒绝</translation>
    </message>
    <message>
        <source>Dropped: the answer to another question</source>
        <translation>已丢弃：另一个问题的应答</translation>
    </message>
    <message>
        <source>Dropped: wrong checksum</source>
        <translation>已丢弃：校验和错误</translation>
    </message>
    <message>
        <source>Dropped: not a frame</source>
        <translation>已丢弃：不是帧</translation>
    </message>
    <message>
        <source>Dropped: the rest did not come in time</source>
        <translation>已丢弃：其余部分未按时到达</translation>
    </message>
    <message>
        <source>No answer in time</source>
        <translation>未按时应答</translation>
    </message>
    <message>
        <source>Dropped: nobody had asked</source>
        <translation>已丢弃：没有人询问</translation>
    </message>
    <message>
        <source>The port has gone</source>
        <translation>端口已消失</translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation>非法功能</translation>
    </message>
    <message>
        <source>illegal register address</source>
        <translation>非法寄存器地址</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>非法值</translation>
    </message>
    <message>
        <source>device failure</source>
        <translation>设备故障</translation>
    </message>
    <message>
        <source>acknowledged, not yet done</source>
        <translation>已确认，尚未完成</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>设备忙</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Status wanted, heartbeat %1</source>
        <translation>询问状态，心跳 %1</translation>
    </message>
    <message>
        <source>Command %1, counter %2</source>
        <comment>name, number</comment>
        <translation>命令 %1，计数 %2</translation>
    </message>
    <message>
        <source>Transfer %1, block %2</source>
        <comment>operation, number</comment>
        <translation>传输 %1，块 %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>写 %1</translation>
    </message>
    <message>
        <source>Sent: function %1</source>
        <translation>已发送：功能 %1</translation>
    </message>
    <message>
        <source>Status: %1, %2</source>
        <comment>state, angle</comment>
        <translation>状态：%1，%2</translation>
    </message>
    <message>
        <source>Command %1: %2</source>
        <comment>name, what became of it</comment>
        <translation>命令 %1：%2</translation>
    </message>
    <message>
        <source>Transfer %1: %2</source>
        <comment>operation, what became of it</comment>
        <translation>传输 %1：%2</translation>
    </message>
    <message>
        <source>Answer: done</source>
        <translation>应答：完成</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>应答：%1</translation>
    </message>
    <message>
        <source>Exception %1: %2</source>
        <comment>number, name</comment>
        <translation>异常 %1：%2</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <comment>what, number</comment>
        <translation>%1，%2 个字节</translation>
    </message>
    <message>
        <source>Unit %1, function %2</source>
        <translation>站号 %1，功能 %2</translation>
    </message>
    <message>
        <source>Read %1, count %2</source>
        <translation>读 %1，数量 %2</translation>
    </message>
</context>
<context>
    <name>LastRecipe</name>
    <message>
        <source>%1 The last good copy is used.</source>
        <translation>%1 已使用最近的完好副本。</translation>
    </message>
    <message>
        <source>%1 There is no good copy; the default recipe is used.</source>
        <translation>%1 没有完好的副本，已使用默认配方。</translation>
    </message>
</context>
<context>
    <name>RecipeComparison</name>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Kind of program</source>
        <translation>程序类型</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>已固定</translation>
    </message>
    <message>
        <source>Law parameter 1</source>
        <translation>规律参数1</translation>
    </message>
    <message>
        <source>Law parameter 2</source>
        <translation>规律参数2</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>节点</translation>
    </message>
    <message numerus="yes">
        <source>%n knot(s)</source>
        <translation>
            <numerusform>%n 个节点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RecipeWords</name>
    <message>
        <source>Bag length</source>
        <translation>袋长</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Base speed v_a</source>
        <translation>基本速度 v_a</translation>
    </message>
    <message>
        <source>Film speed v_b</source>
        <translation>膜速 v_b</translation>
    </message>
    <message>
        <source>Ratio k1</source>
        <translation>比例 k1</translation>
    </message>
    <message>
        <source>Ratio k2</source>
        <translation>比例 k2</translation>
    </message>
    <message>
        <source>Ratio k3</source>
        <translation>比例 k3</translation>
    </message>
    <message>
        <source>Ratio k4</source>
        <translation>比例 k4</translation>
    </message>
    <message>
        <source>Sync ratio</source>
        <translation>同步比</translation>
    </message>
    <message>
        <source>Slices per ramp</source>
        <translation>斜坡分段数</translation>
    </message>
    <message>
        <source>Knife radius R</source>
        <translation>刀尖半径 R</translation>
    </message>
    <message>
        <source>Knives N</source>
        <translation>刀数 N</translation>
    </message>
    <message>
        <source>Pulses per motor rev. K</source>
        <translation>电机每转脉冲 K</translation>
    </message>
    <message>
        <source>Gear Z, motor revs</source>
        <translation>传动比 Z，电机转数</translation>
    </message>
    <message>
        <source>Gear Z, knife revs</source>
        <translation>传动比 Z，刀轴转数</translation>
    </message>
    <message>
        <source>Max. motor speed</source>
        <translation>最高电机转速</translation>
    </message>
    <message>
        <source>Max. acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Max. pulse frequency</source>
        <translation>最高脉冲频率</translation>
    </message>
    <message>
        <source>Max. rate</source>
        <translation>最高速率</translation>
    </message>
    <message>
        <source>Timer clock</source>
        <translation>定时器时钟</translation>
    </message>
    <message>
        <source>Timer width</source>
        <translation>定时器位宽</translation>
    </message>
    <message>
        <source>Rows in the controller</source>
        <translation>控制器行数</translation>
    </message>
    <message>
        <source>bags/min</source>
        <translation>袋/分</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>r/min</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>Cubic (paper)</source>
        <translation>三次（论文）</translation>
    </message>
    <message>
        <source>Quintic 3-4-5</source>
        <translation>五次 3-4-5</translation>
    </message>
    <message>
        <source>Polynomial 4-5-6-7</source>
        <translation>多项式 4-5-6-7</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>简谐</translation>
    </message>
    <message>
        <source>Cycloidal</source>
        <translation>摆线</translation>
    </message>
    <message>
        <source>Modified sine</source>
        <translation>修正正弦</translation>
    </message>
    <message>
        <source>Modified trapezoid</source>
        <translation>修正梯形</translation>
    </message>
    <message>
        <source>Parabolic</source>
        <translation>抛物线</translation>
    </message>
    <message>
        <source>Trapezoid</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>Seven-segment S</source>
        <translation>七段 S 形</translation>
    </message>
    <message>
        <source>Exponential</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>Half modified sine</source>
        <translation>半修正正弦</translation>
    </message>
    <message>
        <source>Ramp fraction r</source>
        <translation>斜坡比例 r</translation>
    </message>
    <message>
        <source>Jerk share q</source>
        <translation>加加速度比例 q</translation>
    </message>
    <message>
        <source>Exponent k</source>
        <translation>指数 k</translation>
    </message>
    <message>
        <source>motor speed</source>
        <translation>电机转速</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>pulse frequency</source>
        <translation>脉冲频率</translation>
    </message>
    <message>
        <source>knife stroke</source>
        <translation>切刀行程</translation>
    </message>
    <message>
        <source>table rows</source>
        <translation>数据表行数</translation>
    </message>
    <message>
        <source>largest rate</source>
        <translation>最高速率</translation>
    </message>
    <message>
        <source>knife speed</source>
        <translation>刀速</translation>
    </message>
    <message>
        <source>Feed per motor rev.</source>
        <translation>电机每转进给</translation>
    </message>
    <message>
        <source>Max. motor torque</source>
        <translation>电机最大转矩</translation>
    </message>
    <message>
        <source>Inertia at the motor</source>
        <translation>折算到电机的惯量</translation>
    </message>
    <message>
        <source>Friction at the motor</source>
        <translation>折算到电机的摩擦转矩</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Start speed</source>
        <translation>起始速度</translation>
    </message>
    <message>
        <source>End speed</source>
        <translation>终了速度</translation>
    </message>
    <message>
        <source>Table intervals</source>
        <translation>表的等分数</translation>
    </message>
    <message>
        <source>Master speed</source>
        <translation>主轴速度</translation>
    </message>
    <message>
        <source>Master ramp</source>
        <translation>主轴加速时间</translation>
    </message>
    <message>
        <source>Master revs/cycle</source>
        <translation>每周期主轴转数</translation>
    </message>
    <message>
        <source>Master scale</source>
        <translation>主轴缩放</translation>
    </message>
    <message>
        <source>Slave scale</source>
        <translation>从轴缩放</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>Approach to</source>
        <translation>快进至</translation>
    </message>
    <message>
        <source>Approach speed</source>
        <translation>快进速度</translation>
    </message>
    <message>
        <source>Probe speed</source>
        <translation>探测速度</translation>
    </message>
    <message>
        <source>Probe force</source>
        <translation>探测力</translation>
    </message>
    <message>
        <source>Touch before</source>
        <translation>最迟接触位置</translation>
    </message>
    <message>
        <source>Press speed</source>
        <translation>压装速度</translation>
    </message>
    <message>
        <source>Press to</source>
        <translation>压装至</translation>
    </message>
    <message>
        <source>Hold time</source>
        <translation>保压时间</translation>
    </message>
    <message>
        <source>Return speed</source>
        <translation>返回速度</translation>
    </message>
    <message>
        <source>Max. force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>Stop tolerance</source>
        <translation>终点允差</translation>
    </message>
    <message>
        <source>Min. force at stop</source>
        <translation>终点最小力</translation>
    </message>
    <message>
        <source>Max. force at stop</source>
        <translation>终点最大力</translation>
    </message>
    <message>
        <source>As a speed law its acceleration is zero at both ends and peaks at only 1.5 times its mean.</source>
        <translation>用作速度规律时，两端加速度为零，峰值仅为平均值的 1.5 倍。</translation>
    </message>
    <message>
        <source>Speed and acceleration are zero at both ends, by one short polynomial.</source>
        <translation>仅用一个简短的多项式，两端速度和加速度均为零。</translation>
    </message>
    <message>
        <source>Speed, acceleration and jerk are all zero at both ends, so it excites little vibration.</source>
        <translation>两端速度、加速度和加加速度均为零，激起的振动很小。</translation>
    </message>
    <message>
        <source>Low peak speed (1.57) and low peak acceleration (4.93) by half a cosine wave.</source>
        <translation>由半个余弦波构成，峰值速度低（1.57），峰值加速度低（4.93）。</translation>
    </message>
    <message>
        <source>Its acceleration is one whole sine wave, smooth throughout and zero at both ends.</source>
        <translation>加速度为一个完整的正弦波，全程光滑，两端为零。</translation>
    </message>
    <message>
        <source>Low peak speed (1.76) with moderate peak acceleration (5.53) and no jump of acceleration: it suits large inertia.</source>
        <translation>峰值速度低（1.76），峰值加速度适中（5.53），加速度无突变，适合大惯量负载。</translation>
    </message>
    <message>
        <source>The lowest peak acceleration (4.89) of the laws without parameters whose acceleration does not jump.</source>
        <translation>在加速度无突变的无参数规律中，峰值加速度最低（4.89）。</translation>
    </message>
    <message>
        <source>The lowest peak acceleration (4) that a move from rest to rest can have.</source>
        <translation>从静止到静止的运动所能达到的最低峰值加速度（4）。</translation>
    </message>
    <message>
        <source>No law has a lower peak speed at the same peak acceleration; the ramp fraction trades one for the other.</source>
        <translation>峰值加速度相同时，没有规律的峰值速度更低；用斜坡比例在二者之间取舍。</translation>
    </message>
    <message>
        <source>Its acceleration does not jump, and both its peak and that of the jerk can be set.</source>
        <translation>加速度无突变，其峰值和加加速度峰值均可设定。</translation>
    </message>
    <message>
        <source>It accelerates hardest at low speed, where a motor has most torque to give, and least near the end speed.</source>
        <translation>低速时电机转矩最充裕，加速度也最大；接近终了速度时加速度最小。</translation>
    </message>
    <message>
        <source>Its acceleration is zero at both ends and peaks at only 1.57 times its mean.</source>
        <translation>两端加速度为零，峰值仅为平均值的 1.57 倍。</translation>
    </message>
    <message>
        <source>As a displacement law its acceleration jumps to its peak (6) at both ends, and as a speed law its jerk does.</source>
        <translation>用作位移规律时，加速度在两端突变到峰值（6）；用作速度规律时，加加速度在两端突变到峰值。</translation>
    </message>
    <message>
        <source>Its jerk steps at both ends, and a trapezoid whose ramps are longer than 22.29 % of the move needs less peak acceleration.</source>
        <translation>加加速度在两端有阶跃；斜坡超过行程时间 22.29 % 的梯形规律所需的峰值加速度更低。</translation>
    </message>
    <message>
        <source>It has the highest peak speed (2.19) and peak acceleration (7.51) of the displacement laws without parameters.</source>
        <translation>在无参数的位移规律中，峰值速度（2.19）和峰值加速度（7.51）最高。</translation>
    </message>
    <message>
        <source>As a displacement law it starts and ends with its full acceleration, a jolt each time.</source>
        <translation>用作位移规律时，起止瞬间即为最大加速度，每次都有冲击。</translation>
    </message>
    <message>
        <source>Its peak speed (2) and peak acceleration (6.28) are high, and its jerk steps at both ends.</source>
        <translation>峰值速度（2）和峰值加速度（6.28）较高，加加速度在两端有阶跃。</translation>
    </message>
    <message>
        <source>Its jerk steps at both ends and has the highest finite peak (69.5) of the laws without parameters.</source>
        <translation>加加速度在两端有阶跃，且其有限峰值（69.5）在无参数规律中最高。</translation>
    </message>
    <message>
        <source>Its peak speed (2) and peak jerk (61.4) are high, and its jerk steps at both ends.</source>
        <translation>峰值速度（2）和峰值加加速度（61.4）较高，加加速度在两端有阶跃。</translation>
    </message>
    <message>
        <source>As a displacement law its acceleration jumps at both ends and in the middle, and its peak speed (2) is high.</source>
        <translation>用作位移规律时，加速度在两端和中点突变，峰值速度（2）较高。</translation>
    </message>
    <message>
        <source>As a displacement law its acceleration jumps at both ends of both ramps, so its jerk has no bound.</source>
        <translation>用作位移规律时，加速度在两段斜坡的两端突变，加加速度无界。</translation>
    </message>
    <message>
        <source>Its jerk steps at every joint of its segments, and the smaller the jerk share the higher it is.</source>
        <translation>加加速度在各段衔接处有阶跃，加加速度比例越小，其值越大。</translation>
    </message>
    <message>
        <source>Its acceleration jumps at both ends, at the low speed the more the larger k is.</source>
        <translation>加速度在两端突变，k 越大，低速端的突变越大。</translation>
    </message>
    <message>
        <source>It is not symmetric: from rest it travels 0.568 of end speed times time; and its jerk steps at both ends.</source>
        <translation>不对称：从静止起步的行程为终了速度与时间乘积的 0.568 倍；加加速度在两端有阶跃。</translation>
    </message>
    <message>
        <source>Rotary cutter</source>
        <translation>旋转切刀</translation>
    </message>
    <message>
        <source>Position move</source>
        <translation>位置运动</translation>
    </message>
    <message>
        <source>Speed move</source>
        <translation>速度运动</translation>
    </message>
    <message>
        <source>Point cam</source>
        <translation>型值点凸轮</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>压装</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>运动规律</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Executed as</source>
        <translation>执行方式</translation>
    </message>
    <message>
        <source>Spline ends</source>
        <translation>样条端点</translation>
    </message>
    <message>
        <source>Shape of the ramp</source>
        <translation>加速曲线形状</translation>
    </message>
    <message>
        <source>In a given time</source>
        <translation>给定时间</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>Over a distance</source>
        <translation>给定距离</translation>
    </message>
    <message>
        <source>Cam points</source>
        <translation>凸轮点</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>自然</translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation>固支</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>S curve</source>
        <translation>S 形曲线</translation>
    </message>
    <message>
        <source>motor torque</source>
        <translation>电机转矩</translation>
    </message>
    <message>
        <source>From the middle of the shaft to the edge of the knife. Measure the diameter at the edge and halve it. All speeds of the knife are those of this edge.</source>
        <translation>从轴心到刀刃的距离。在刀刃处测量直径后除以二。切刀的所有速度都是刀刃的速度。</translation>
    </message>
    <message>
        <source>Knives on the shaft, evenly spread. Each bag turns the shaft by one knife.</source>
        <translation>轴上均匀分布的切刀数。每个袋使轴转过一把刀。</translation>
    </message>
    <message>
        <source>Pulses for one turn of the motor, as the electronic gear of the servo drive is set. A wrong number makes all bags too long or too short.</source>
        <translation>电机每转的脉冲数，按伺服驱动器的电子齿轮设定。数值错误会使所有袋偏长或偏短。</translation>
    </message>
    <message>
        <source>Turns of the motor for the turns of the knife&apos;s shaft below, as the gear&apos;s plate says: 7 and 3 for a gear of 7:3.</source>
        <translation>对应下方刀轴转数的电机转数，见减速机铭牌：7:3 的减速机填 7 和 3。</translation>
    </message>
    <message>
        <source>Turns of the knife&apos;s shaft for the turns of the motor above.</source>
        <translation>对应上方电机转数的刀轴转数。</translation>
    </message>
    <message>
        <source>The largest speed of the motor, from its plate. No recipe goes beyond it.</source>
        <translation>电机最高转速，见铭牌。任何配方都不会超过它。</translation>
    </message>
    <message>
        <source>What motor and mechanics bear without shaking or losing their position. Begin low, and raise it when the following error allows.</source>
        <translation>电机和机械能承受而不抖动、不丢位置的加速度。先取小值，跟随误差允许时再提高。</translation>
    </message>
    <message>
        <source>The largest pulse frequency of the drive&apos;s input, from its manual. The controller has a limit of its own.</source>
        <translation>驱动器输入的最高脉冲频率，见其手册。控制器另有自身的限值。</translation>
    </message>
    <message>
        <source>What sealing time and infeed allow, whatever the knife could do.</source>
        <translation>封口时间和进料允许的最高速率，与切刀能力无关。</translation>
    </message>
    <message>
        <source>How far the axis moves in one turn of the motor, gear and spindle included.</source>
        <translation>电机每转轴移动的距离，含减速机和丝杠。</translation>
    </message>
    <message>
        <source>The torque that the motor gives for a moment, from its plate.</source>
        <translation>电机短时转矩，见铭牌。</translation>
    </message>
    <message>
        <source>Motor, gear and load together, seen from the motor. With it the torque of a motion is estimated.</source>
        <translation>折算到电机的电机、减速机和负载总惯量，用于估算运动所需转矩。</translation>
    </message>
    <message>
        <source>The torque that turns the axis slowly and steadily, seen from the motor.</source>
        <translation>使轴缓慢匀速转动的转矩，折算到电机。</translation>
    </message>
</context>
<context>
    <name>RefusalSentences</name>
    <message>
        <source>%1 %2</source>
        <comment>%1: number, %2: unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>%1: name of a field, %2: value with unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Within all limits.</source>
        <translation>在所有限制之内。</translation>
    </message>
    <message>
        <source>Within all limits. Fastest possible: %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>在所有限制之内。最快可达 %1（受限于%2）。</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>刚好在限制之内。</translation>
    </message>
    <message>
        <source>Just within the limits. Fastest possible: %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>刚好在限制之内。最快可达 %1（受限于%2）。</translation>
    </message>
    <message>
        <source>The motor would turn at %1 at %3 s (%4°); the limit is %2.</source>
        <translation>电机在 %3 s（%4°）处将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The knife would accelerate with %1 at %3 s (%4°); the limit is %2.</source>
        <translation>切刀在 %3 s（%4°）处的加速度将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The pulse frequency would be %1 at %3 s (%4°); the limit is %2.</source>
        <translation>脉冲频率在 %3 s（%4°）处将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>%1 would be needed; the limit of the machine is %2.</source>
        <translation>需要 %1，机器的限制为 %2。</translation>
    </message>
    <message>
        <source>%1 has no value. Enter %2 to %3.</source>
        <translation>%1没有值。请输入 %2 到 %3。</translation>
    </message>
    <message>
        <source>%1 would be %2; possible is %3 to %4.</source>
        <translation>%1将为 %2，允许范围为 %3 到 %4。</translation>
    </message>
    <message>
        <source>Pin two different ones of bag length, rate, base speed and film speed.</source>
        <translation>请从袋长、速率、基本速度和膜速中固定两个不同的量。</translation>
    </message>
    <message>
        <source>This speed law is not known. Choose another one.</source>
        <translation>无法识别此速度规律。请选择其他规律。</translation>
    </message>
    <message>
        <source>%1 is %2; the nearest possible value is %3.</source>
        <translation>%1为 %2，最接近的允许值为 %3。</translation>
    </message>
    <message>
        <source>The ratios must descend from k1 to k4: %1 is %2 and must stay below %3.</source>
        <translation>比例必须从 k1 到 k4 递减：%1为 %2，必须小于 %3。</translation>
    </message>
    <message>
        <source>A bag of %1 takes more than the knife&apos;s stroke; with these ratios %2 is the longest.</source>
        <translation>%1 的袋长超过切刀行程，按当前比例最长为 %2。</translation>
    </message>
    <message>
        <source>The table needs %1 rows, the controller holds %2. Use fewer slices per ramp.</source>
        <translation>数据表需要 %1 行，控制器只有 %2 行。请减少斜坡分段数。</translation>
    </message>
    <message>
        <source>A cycle has only %1 pulses. Check pulses per revolution, gear and knives.</source>
        <translation>一个周期只有 %1 个脉冲。请检查每转脉冲、传动比和刀数。</translation>
    </message>
    <message>
        <source>The motor would turn at %1 at %3 s; the limit is %2.</source>
        <translation>电机在 %3 s 处的转速将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The acceleration would be %1 at %3 s; the limit is %2.</source>
        <translation>%3 s 处的加速度将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The motor would need %1 at %3 s; it has %2.</source>
        <translation>%3 s 处电机需要 %1，而它只有 %2。</translation>
    </message>
    <message>
        <source>Following the master would take %1 at %3 s; the limit is %2.</source>
        <translation>跟随主轴在 %3 s 处需要 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The pulse frequency would be %1 at %3 s; the limit is %2.</source>
        <translation>%3 s 处的脉冲频率将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The cam has %1 knots; the nearest possible number is %2.</source>
        <translation>凸轮有 %1 个型值点，最接近的允许数目为 %2。</translation>
    </message>
    <message>
        <source>Knot %1 at %2 must come after the one before it at %3.</source>
        <translation>型值点 %1（%2）必须位于前一点（%3）之后。</translation>
    </message>
    <message>
        <source>Knot %1 is only %2 after the one before it; keep %3.</source>
        <translation>型值点 %1 距前一点仅 %2，至少应为 %3。</translation>
    </message>
    <message>
        <source>Knot %1 at %2 is out of range; the nearest place is %3.</source>
        <translation>型值点 %1（%2）超出范围，最近的允许位置为 %3。</translation>
    </message>
    <message>
        <source>Knot %1 is at %2, but the cam needs one at %3.</source>
        <translation>型值点 %1 位于 %2，但凸轮在 %3 处需要一个型值点。</translation>
    </message>
    <message>
        <source>Near knot %1 the curve reaches %2, beyond the range of the knots, which ends at %3. Move the knot or add one beside it.</source>
        <translation>在型值点 %1 附近曲线达到 %2，超出型值点的范围（到 %3 为止）。请移动该点或在旁边增加一点。</translation>
    </message>
    <message>
        <source>The position jumps by %1 where the cycle closes. Choose periodic ends.</source>
        <translation>周期闭合处位置跳变 %1。请选择周期端点。</translation>
    </message>
    <message>
        <source>The speed jumps by %1 where the cycle closes. Choose periodic ends.</source>
        <translation>周期闭合处速度跳变 %1。请选择周期端点。</translation>
    </message>
    <message>
        <source>The acceleration jumps by %1 where the cycle closes. Choose periodic ends.</source>
        <translation>周期闭合处加速度跳变 %1。请选择周期端点。</translation>
    </message>
    <message>
        <source>%1 is %2: nothing would move. Enter another value.</source>
        <translation>%1为 %2：不会产生运动。请输入其他值。</translation>
    </message>
    <message>
        <source>The speeds need at least %1, not %2.</source>
        <translation>这些速度至少需要 %1，而不是 %2。</translation>
    </message>
    <message>
        <source>A distance of %1 points the other way than the speeds. Change its sign.</source>
        <translation>距离 %1 与速度方向相反。请改变其符号。</translation>
    </message>
    <message>
        <source>%1 %2 must be beyond %3.</source>
        <translation>%1 %2 必须超过 %3。</translation>
    </message>
    <message>
        <source>%1 %2 must be at most %3.</source>
        <translation>%1 %2 不得大于 %3。</translation>
    </message>
    <message>
        <source>The table does not fit the controller. Use fewer pulses per revolution or a shorter motion.</source>
        <translation>数据表超出控制器的范围。请减少每转脉冲数或缩短运动。</translation>
    </message>
    <message>
        <source>%1 needs a ramp of %2 ms with the largest acceleration; the controller takes at most %3 ms. Enter a lower speed or a larger acceleration.</source>
        <translation>%1以最大加速度需要 %2 ms 的斜坡，控制器最多 %3 ms。请输入更低的速度或更大的加速度。</translation>
    </message>
    <message>
        <source>The motion turns round, and intervals go one way. Choose cam points.</source>
        <translation>运动会反向，而区间方式只能单向。请选择凸轮点方式。</translation>
    </message>
    <message>
        <source>Whole pulses cannot keep the speed within %1 mm/s. Use more pulses per revolution.</source>
        <translation>整数脉冲无法把速度误差保持在 %1 mm/s 以内。请增加每转脉冲数。</translation>
    </message>
    <message>
        <source>The acceleration would be %1 at %3 s (%4°); the limit is %2.</source>
        <translation>在 %3 s（%4°）处的加速度将达到 %1，限制为 %2。</translation>
    </message>
    <message>
        <source>The motor would need %1 at %3 s (%4°); it has %2.</source>
        <translation>在 %3 s（%4°）处电机将需要 %1，而它只有 %2。</translation>
    </message>
    <message>
        <source>Following the master would take %1 at %3 s (%4°); the limit is %2.</source>
        <translation>在 %3 s（%4°）处跟随主轴将需要 %1，限制为 %2。</translation>
    </message>
</context>
<context>
    <name>RegisterWords</name>
    <message>
        <source>Identity</source>
        <translation>标识</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>交换</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Command result</source>
        <translation>命令结果</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>传输</translation>
    </message>
    <message>
        <source>Transfer result</source>
        <translation>传输结果</translation>
    </message>
    <message>
        <source>Read-back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>Read-back result</source>
        <translation>回读结果</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>运行中的程序</translation>
    </message>
    <message>
        <source>Staged program</source>
        <translation>待用的程序</translation>
    </message>
    <message>
        <source>Read only: the panel writes this register itself with every status.</source>
        <translation>只读：面板每次询问状态时自己写入此寄存器。</translation>
    </message>
    <message>
        <source>Read only: commands go out by their keys, each once and with a counter of its own.</source>
        <translation>只读：命令由各自的按键发出，每个只发一次，并带有自己的计数。</translation>
    </message>
    <message>
        <source>Read only: written by downloads.</source>
        <translation>只读：由下载写入。</translation>
    </message>
    <message>
        <source>Read only: the panel writes this register itself to read others.</source>
        <translation>只读：面板自己写入此寄存器来读取其他寄存器。</translation>
    </message>
    <message>
        <source>Read only: changed by the download of a whole program.</source>
        <translation>只读：由整个程序的下载来改变。</translation>
    </message>
    <message>
        <source>Read only: set by the panel after connecting.</source>
        <translation>只读：连接后由面板设置。</translation>
    </message>
    <message>
        <source>Read only: the controller alone writes this register.</source>
        <translation>只读：只有控制器写入此寄存器。</translation>
    </message>
</context>
<context>
    <name>StoreErrorText</name>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>The panel&apos;s memory %1 cannot be opened: %2. Check the disk and its permissions.</source>
        <translation>无法打开面板的存储 %1：%2。请检查磁盘及其权限。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory %1 was written by a newer version of CamPanel. Install that version.</source>
        <translation>面板的存储 %1 由更新版本的 CamPanel 写入。请安装该版本。</translation>
    </message>
    <message>
        <source>The disk is full. What was saved before is kept; make room and save again.</source>
        <translation>磁盘已满。以前保存的内容仍在；请腾出空间后再次保存。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory %1 is write-protected. Check the disk and its permissions.</source>
        <translation>面板的存储 %1 被写保护。请检查磁盘及其权限。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory did not take this: %1.</source>
        <translation>面板的存储未能接受：%1。</translation>
    </message>
    <message>
        <source>The records of bags and trends were damaged and begin anew. The damaged file is kept as %1.</source>
        <translation>袋记录和趋势文件已损坏，现重新开始记录。损坏的文件保存为 %1。</translation>
    </message>
    <message>
        <source>there is no such user</source>
        <translation>没有此用户</translation>
    </message>
    <message>
        <source>somebody of the level Service must be left</source>
        <translation>必须至少保留一名“维护”级用户</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>The panel&apos;s memory %1 is damaged. Restart the panel: the last good copy takes its place, if there is one.</source>
        <translation>面板的存储 %1 已损坏。请重新启动面板：如有最近的完好副本，将由其代替。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory %1 is in use by another program. Close that program, then restart the panel.</source>
        <translation>面板的存储 %1 正被另一个程序使用。请关闭该程序，然后重新启动面板。</translation>
    </message>
    <message>
        <source>The users of this panel and their PINs are lost. Only operators can work until they are back. To start without PINs, delete the file %1 and restart the panel; then restore a backup.</source>
        <translation>此面板的用户及其 PIN 已丢失。恢复之前只有操作员可以工作。如要不用 PIN 开始，请删除文件 %1 并重新启动面板，然后恢复备份。</translation>
    </message>
</context>
<context>
    <name>TableText</name>
    <message>
        <source>Step table</source>
        <translation>步进表</translation>
    </message>
    <message>
        <source>Cam points</source>
        <translation>凸轮点</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>Press stages</source>
        <translation>压装阶段</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>段</translation>
    </message>
    <message>
        <source>Time s</source>
        <translation>时间 s</translation>
    </message>
    <message>
        <source>Frequency Hz</source>
        <translation>频率 Hz</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>Timer ticks</source>
        <translation>定时器计数</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Position mm</source>
        <translation>位置 mm</translation>
    </message>
    <message>
        <source>Slope pulses</source>
        <translation>斜率（脉冲）</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动方式</translation>
    </message>
    <message>
        <source>First Hz</source>
        <translation>起始 Hz</translation>
    </message>
    <message>
        <source>Last Hz</source>
        <translation>终了 Hz</translation>
    </message>
    <message>
        <source>Hz/s</source>
        <translation>Hz/s</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Speed Hz</source>
        <translation>速度 Hz</translation>
    </message>
    <message>
        <source>End pulses</source>
        <translation>终点（脉冲）</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>力 N</translation>
    </message>
    <message>
        <source>Time ms</source>
        <translation>时间 ms</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>加速</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>减速</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>匀速</translation>
    </message>
    <message>
        <source>base</source>
        <translation>基速</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sync</source>
        <translation>同步</translation>
    </message>
    <message>
        <source>%1 rows, %2 pulses per cycle, %3 s</source>
        <translation>%1 行，每周期 %2 个脉冲，%3 s</translation>
    </message>
    <message>
        <source>Largest speed error: %1 mm/s (%2 %) at %3 s</source>
        <translation>最大速度误差：%1 mm/s（%2 %），在 %3 s</translation>
    </message>
    <message>
        <source>Largest frequency step: %1 Hz at %2 s</source>
        <translation>最大频率阶跃：%1 Hz，在 %2 s</translation>
    </message>
    <message>
        <source>Largest position error: %1 pulses between rows, %2 inside</source>
        <translation>最大位置误差：行间 %1 个脉冲，行内 %2 个脉冲</translation>
    </message>
    <message>
        <source>Drift: none, the fraction of a pulse is carried from cycle to cycle</source>
        <translation>漂移：无，脉冲的小数部分逐周期累积</translation>
    </message>
    <message>
        <source>The paper&apos;s rule would be wrong by %1 pulses (%2 mm) in each bag</source>
        <translation>按论文的取整方法，每袋将差 %1 个脉冲（%2 mm）</translation>
    </message>
    <message>
        <source>%1 points, %2 pulses per cycle, %3 s</source>
        <translation>%1 个点，每周期 %2 个脉冲，%3 s</translation>
    </message>
    <message>
        <source>Largest position error between points: %1 pulses (%2 mm) at %3 s</source>
        <translation>点间最大位置误差：%1 个脉冲（%2 mm），在 %3 s</translation>
    </message>
    <message>
        <source>Largest speed error: %1 mm/s at %2 s</source>
        <translation>最大速度误差：%1 mm/s，在 %2 s</translation>
    </message>
    <message>
        <source>%1 intervals, %2 pulses, %3 s instead of %4 s</source>
        <translation>%1 个区间，%2 个脉冲，%3 s（设定 %4 s）</translation>
    </message>
    <message>
        <source>Largest speed error: %1 mm/s at %2 s, position: %3 pulses</source>
        <translation>最大速度误差：%1 mm/s，在 %2 s；位置：%3 个脉冲</translation>
    </message>
    <message>
        <source>%1 stages; the last stretch is counted in the pulse generator, %2 mm a pulse</source>
        <translation>%1 个阶段；最后一段由脉冲发生器计数，每脉冲 %2 mm</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Access</name>
    <message>
        <source>A name has 1 to %1 characters.</source>
        <translation>名称为 1 至 %1 个字符。</translation>
    </message>
    <message>
        <source>Somebody has this name already.</source>
        <translation>此名称已有人使用。</translation>
    </message>
    <message>
        <source>There is not enough memory to keep a PIN safely. Restart the panel.</source>
        <translation>内存不足，无法安全保存 PIN。请重新启动面板。</translation>
    </message>
    <message>
        <source>%1 can log in now.</source>
        <translation>%1 现在可以登录。</translation>
    </message>
    <message>
        <source>%1 has a new PIN.</source>
        <translation>%1 有了新的 PIN。</translation>
    </message>
    <message>
        <source>%1 is now of the level %2.</source>
        <translation>%1 现在的级别为%2。</translation>
    </message>
    <message>
        <source>%1 cannot log in any more.</source>
        <translation>%1 不能再登录。</translation>
    </message>
    <message>
        <source>Somebody of the level Service must be left.</source>
        <translation>必须至少保留一名“维护”级用户。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmDetail</name>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>A newer version of the panel has logged it.</source>
        <translation>由较新版本的面板记录。</translation>
    </message>
    <message>
        <source>still active</source>
        <translation>尚未恢复</translation>
    </message>
    <message>
        <source>not known: panel or controller were switched meanwhile</source>
        <translation>未知：期间面板关机或更换了控制器</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>not necessary</source>
        <translation>无需确认</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>time, person</comment>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Audit</name>
    <message>
        <source>Checking the chain …</source>
        <translation>正在检查链…</translation>
    </message>
    <message>
        <source>Not checked yet.</source>
        <translation>尚未检查。</translation>
    </message>
    <message>
        <source>audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>所有人</translation>
    </message>
    <message>
        <source>Row and time</source>
        <translation>行号和时间</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读值</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>哈希</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AxisSpeed</name>
    <message>
        <source>Jog speed</source>
        <translation>点动速度</translation>
    </message>
    <message>
        <source>Homing speed</source>
        <translation>回零速度</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 · %2 mm/s</source>
        <comment>1,000 Hz · 3.1 mm/s</comment>
        <translation>%1 · %2 mm/s</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Backup</name>
    <message>
        <source>The database could not be opened: a backup would be empty. Correct this first, then restart the panel.</source>
        <translation>数据库无法打开，备份将为空。请先排除故障，再重启面板。</translation>
    </message>
    <message>
        <source>CamPanel backup %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel 备份 %1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>date, person</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 · recipes: %2 · users: %3 · CamPanel %4</source>
        <comment>when, how many, how many, version</comment>
        <translation>%1 · 配方：%2 · 用户：%3 · CamPanel %4</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>what is in it, place</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>cannot be used · %1</source>
        <comment>place</comment>
        <translation>无法使用 · %1</translation>
    </message>
    <message>
        <source>The file is checked first. Nothing is changed before you confirm.</source>
        <translation>先检查文件。确认之前不会更改任何内容。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before restoring; the panel will restart.</source>
        <translation>机器正在运动。请先停机：恢复后面板将重新启动。</translation>
    </message>
    <message>
        <source>CamPanel before restore %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel 恢复前 %1</translation>
    </message>
    <message>
        <source>The restore was not begun: %1. Nothing was changed.</source>
        <translation>恢复未开始：%1。没有任何更改。</translation>
    </message>
    <message>
        <source>The file is whole: %1.
Recipes, machine data, users with their PINs, alarms, audit trail and settings of this panel are replaced by those of the file. Bags and trends stay. The present state is kept as a backup on this panel. The panel then starts anew.</source>
        <translation>文件完整：%1。
本面板的配方、机器数据、用户及其 PIN、报警、审计记录和设置将被文件中的内容替换。袋子记录和趋势保留。当前状态在本面板上保存为备份。随后面板重新启动。</translation>
    </message>
    <message>
        <source>The file is whole: %1.
Recipes, machine data, users with their PINs, alarms, audit trail, bags, trends and settings of this panel are replaced by those of the file. The present state is kept as a backup on this panel. The panel then starts anew.</source>
        <translation>文件完整：%1。
本面板的配方、机器数据、用户及其 PIN、报警、审计记录、袋子记录、趋势和设置将被文件中的内容替换。当前状态在本面板上保存为备份。随后面板重新启动。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Commissioning</name>
    <message>
        <source>%1 commissioning %2</source>
        <comment>name of a file: recipe, date</comment>
        <translation>%1 调试报告 %2</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>The recipe has been edited since it was saved or downloaded.</source>
        <translation>配方在保存或下载之后又被编辑过。</translation>
    </message>
    <message>
        <source>Machine data</source>
        <translation>机器数据</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Peaks</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>There is no table: the recipe cannot be downloaded.</source>
        <translation>没有表：该配方无法下载。</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>寄存器表</translation>
    </message>
    <message>
        <source>Connected by</source>
        <translation>连接方式</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>仿真控制器</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>运行中的程序</translation>
    </message>
    <message>
        <source>Saved program</source>
        <translation>已保存的程序</translation>
    </message>
    <message>
        <source>Its table was not read back for this report.</source>
        <translation>本报告没有回读控制器的表。</translation>
    </message>
    <message>
        <source>Last bags</source>
        <translation>最近的袋子</translation>
    </message>
    <message>
        <source>No bag has been measured.</source>
        <translation>尚未测量袋子。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>已测量</translation>
    </message>
    <message>
        <source>Mean length</source>
        <translation>平均袋长</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>平均偏差</translation>
    </message>
    <message>
        <source>Scatter (standard deviation)</source>
        <translation>离散（标准差）</translation>
    </message>
    <message>
        <source>Within ±%1 mm</source>
        <translation>±%1 mm 以内</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>调试报告</translation>
    </message>
    <message>
        <source>%1 · version %2</source>
        <comment>recipe</comment>
        <translation>%1 · 版本 %2</translation>
    </message>
    <message>
        <source>nobody logged in</source>
        <translation>无人登录</translation>
    </message>
    <message>
        <source>%1 · %2 · CamPanel %3</source>
        <comment>date, person, version</comment>
        <translation>%1 · %2 · CamPanel %3</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Curves of one cycle</source>
        <translation>一个周期的曲线</translation>
    </message>
    <message>
        <source>Velocity, mm/s</source>
        <translation>速度，mm/s</translation>
    </message>
    <message>
        <source>Acceleration, m/s²</source>
        <translation>加速度，m/s²</translation>
    </message>
    <message>
        <source>Pulse frequency, kHz</source>
        <translation>脉冲频率，kHz</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>极限</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramDownload</name>
    <message>
        <source>Not possible now: there is no connection to the controller.</source>
        <translation>暂时无法下载：没有连接到控制器。</translation>
    </message>
    <message>
        <source>Not possible: the machine cannot do this recipe.</source>
        <translation>无法下载：机器不能执行此配方。</translation>
    </message>
    <message>
        <source>Not possible: this controller cannot execute this kind of program.</source>
        <translation>无法下载：该控制器不能执行这类程序。</translation>
    </message>
    <message>
        <source>Controller: not known yet</source>
        <translation>控制器：尚不清楚</translation>
    </message>
    <message>
        <source>Controller: reading its program …</source>
        <translation>控制器：正在读取程序…</translation>
    </message>
    <message>
        <source>The controller has no program</source>
        <translation>控制器没有程序</translation>
    </message>
    <message>
        <source>Active in controller: generation %1</source>
        <translation>控制器当前：第 %1 代</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · the same</source>
        <translation>控制器当前：第 %1 代 · 相同</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · 1 value differs</source>
        <translation>控制器当前：第 %1 代 · 1 个值不同</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · %2 values differ</source>
        <translation>控制器当前：第 %1 代 · %2 个值不同</translation>
    </message>
    <message>
        <source>The kind of program and the data of the machine change only at standstill. Stop the machine first.</source>
        <translation>程序类型和机器数据只能在静止时更改。请先停机。</translation>
    </message>
    <message>
        <source>No connection. Last known in the controller: generation %1</source>
        <translation>没有连接。控制器中最后已知的是：第 %1 代</translation>
    </message>
    <message>
        <source>The controller already has this program.</source>
        <translation>控制器中已是这一配方。</translation>
    </message>
    <message>
        <source>The machine keeps running; the new recipe begins with the next cycle.</source>
        <translation>机器继续运行，新配方从下一周期开始。</translation>
    </message>
    <message>
        <source>The new recipe is used from the next start.</source>
        <translation>新配方从下次启动起使用。</translation>
    </message>
    <message>
        <source>Downloaded. The machine runs with this recipe.</source>
        <translation>已下载。机器正按此配方运行。</translation>
    </message>
    <message>
        <source>Downloaded. Press Start to run this recipe.</source>
        <translation>已下载。按“启动”运行此配方。</translation>
    </message>
    <message>
        <source>Downloaded. The controller has this recipe.</source>
        <translation>已下载。控制器中已是此配方。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::DryRun</name>
    <message>
        <source>Time in the cycle</source>
        <translation>周期内时间</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>%1 m/s²</source>
        <translation>%1 m/s²</translation>
    </message>
    <message>
        <source>Pulse frequency</source>
        <translation>脉冲频率</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Knife speed</source>
        <translation>刀速</translation>
    </message>
    <message>
        <source>Film speed</source>
        <translation>膜速</translation>
    </message>
    <message>
        <source>Knife against film</source>
        <translation>刀速与膜速之比</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Synchronous zone</source>
        <translation>同步区</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Editor</name>
    <message>
        <source>Displacement law</source>
        <translation>位移规律</translation>
    </message>
    <message>
        <source>Speed law</source>
        <translation>速度规律</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Explanations</name>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>bags/min</source>
        <translation>袋/分</translation>
    </message>
    <message>
        <source>How many bags a minute the knife cuts at the speed that the master has now. Nobody counts them for this number.</source>
        <translation>以主轴当前速度，切刀每分钟切断的袋数。此数是推算的，并非计数所得。</translation>
    </message>
    <message>
        <source>rate of the program × master speed</source>
        <translation>程序速率 × 主轴速度</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mean bag length</source>
        <translation>平均袋长</translation>
    </message>
    <message>
        <source>Mean of the last bags (%1, at most 60) since the set length was changed.</source>
        <translation>设定长度更改以来最近若干袋（%1 个，最多 60 个）的平均值。</translation>
    </message>
    <message>
        <source>set length + sum of their deviations / bags</source>
        <translation>设定长度 + 偏差之和 / 袋数</translation>
    </message>
    <message>
        <source>Scatter of the bag length</source>
        <translation>袋长离散度</translation>
    </message>
    <message>
        <source>Standard deviation of the last bags (%1): about two thirds of the bags are closer to the mean than this.</source>
        <translation>最近若干袋（%1 个）的标准差：约三分之二的袋与平均值之差小于此值。</translation>
    </message>
    <message>
        <source>√(sum of (deviation − mean deviation)² / (bags − 1))</source>
        <translation>√((偏差 − 平均偏差)² 之和 / (袋数 − 1))</translation>
    </message>
    <message>
        <source>Bags within the tolerance</source>
        <translation>公差内的袋数</translation>
    </message>
    <message>
        <source>How many of the last bags (%1) are within ±%2 mm. The tolerance is set in Settings, Machine.</source>
        <translation>最近若干袋（%1 个）中在 ±%2 mm 以内的袋数。公差在“设置”的“机器”中设定。</translation>
    </message>
    <message>
        <source>bags whose deviation is not above the tolerance</source>
        <translation>偏差不超过公差的袋数</translation>
    </message>
    <message>
        <source>Deviation of the last bag</source>
        <translation>最后一袋的偏差</translation>
    </message>
    <message>
        <source>Positive: the bag is too long. Where cuts were left out, the set length is that of all its lengths.</source>
        <translation>正值表示袋过长。若省略了切断，设定长度为所含各段长度之和。</translation>
    </message>
    <message>
        <source>measured length − set length</source>
        <translation>实测长度 − 设定长度</translation>
    </message>
    <message>
        <source>Mark error</source>
        <translation>色标误差</translation>
    </message>
    <message>
        <source>Of the last cut that had a mark, as the controller measured it. The tracker turns the film by a part of it, cut after cut.</source>
        <translation>控制器对最后一次有色标的切断所测的误差。跟踪器在每次切断时按其一部分修正薄膜。</translation>
    </message>
    <message>
        <source>where the cut was − where its mark wanted it</source>
        <translation>实际切断位置 − 色标要求的位置</translation>
    </message>
    <message>
        <source>Film saved</source>
        <translation>节省的薄膜</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Film that bags without product would have used up: the film waited instead. Counted since the controller was switched on.</source>
        <translation>无产品的空袋本会用掉的薄膜：薄膜改为等待。自控制器上电起累计。</translation>
    </message>
    <message>
        <source>bags left out × their mean length</source>
        <translation>省去的袋数 × 平均袋长</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>跟随误差</translation>
    </message>
    <message>
        <source>How far the axis was from where the program wanted it, when the controller told last.</source>
        <translation>控制器最近一次报告时，轴与程序要求位置之差。</translation>
    </message>
    <message>
        <source>error in pulses / pulses per mm</source>
        <translation>误差脉冲数 / 每 mm 脉冲数</translation>
    </message>
    <message>
        <source>Good of the last strokes</source>
        <translation>最近行程中的合格数</translation>
    </message>
    <message>
        <source>Of the last strokes (%1), those that ended inside the gate: at the press position, with a force of %2 to %3 N.</source>
        <translation>最近若干行程（%1 次）中，终点落在判定窗口内的次数：在压装位置，力为 %2 至 %3 N。</translation>
    </message>
    <message>
        <source>strokes that the controller called good</source>
        <translation>控制器判为合格的行程数</translation>
    </message>
    <message>
        <source>Fastest possible rate</source>
        <translation>最高可行速率</translation>
    </message>
    <message>
        <source>With this bag length, law and machine. What ends it first: %1. Speeds grow with the rate, the acceleration with its square.</source>
        <translation>在此袋长、运动规律和机器下。最先达到的限制：%1。速度与速率成正比，加速度与其平方成正比。</translation>
    </message>
    <message>
        <source>rate × allowed / peak, rounded down</source>
        <translation>速率 × 允许值 / 峰值，向下取整</translation>
    </message>
    <message>
        <source>rate × √(allowed / peak), rounded down</source>
        <translation>速率 × √(允许值 / 峰值)，向下取整</translation>
    </message>
    <message>
        <source>the limit itself</source>
        <translation>即该限制值</translation>
    </message>
    <message>
        <source>Highest motor speed</source>
        <translation>电机最高转速</translation>
    </message>
    <message>
        <source>Where the knife is fastest.</source>
        <translation>切刀最快之处。</translation>
    </message>
    <message>
        <source>Highest acceleration of the knife</source>
        <translation>切刀最大加速度</translation>
    </message>
    <message>
        <source>Where its speed changes most quickly.</source>
        <translation>其速度变化最快之处。</translation>
    </message>
    <message>
        <source>Highest pulse frequency</source>
        <translation>最高脉冲频率</translation>
    </message>
    <message>
        <source>What the controller has to put out where the knife is fastest.</source>
        <translation>切刀最快之处控制器须输出的频率。</translation>
    </message>
    <message>
        <source>Share of the wire&apos;s limit</source>
        <translation>占线路极限的比例</translation>
    </message>
    <message>
        <source>How much of the time that the exchanges took the frames themselves need at this baud rate, with the silences of the standard. At 100 % no master could ask faster; what is missing was spent waiting for the controller, the adapter or answers that never came.</source>
        <translation>在此波特率下，帧本身连同标准规定的静默时间占通信所用时间的比例。达到 100 % 时，任何主站都不可能问得更快；不足的部分用于等待控制器、适配器或始终未到的应答。</translation>
    </message>
    <message>
        <source>time of the frames on the wire / time of the exchanges</source>
        <translation>帧在线路上的时间 / 通信所用时间</translation>
    </message>
    <message>
        <source>%1 s / %2 s</source>
        <translation>%1 s / %2 s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Longest time of an answer</source>
        <translation>最长应答时间</translation>
    </message>
    <message>
        <source>From handing the question to the port to the last byte of its answer. One single answer, perhaps hours ago: the percentages say more about every day.</source>
        <translation>从把询问交给端口到收到应答的最后一个字节。这只是一次应答，可能在数小时之前：各百分比更能说明日常情况。</translation>
    </message>
    <message>
        <source>the longest since the count began</source>
        <translation>计数开始以来的最长时间</translation>
    </message>
    <message>
        <source>Half of the answers came within</source>
        <translation>半数应答不超过</translation>
    </message>
    <message>
        <source>%1 % of the answers came within</source>
        <translation>%1 % 的应答不超过</translation>
    </message>
    <message>
        <source>From handing the question to the port to the last byte of its answer, both frames on the wire included. Counted since the panel was started or Count from zero was pressed.</source>
        <translation>从把询问交给端口到收到应答的最后一个字节，包括两帧在线路上的时间。自面板启动或按下“从零计数”起统计。</translation>
    </message>
    <message>
        <source>all answers in the order of their times: the time of the one at %1 % of their number, at most 6.25 % too high, never too low</source>
        <translation>所有应答按时间排序：取排在总数 %1 % 处的那一个的时间，最多偏高 6.25 %，绝不偏低</translation>
    </message>
    <message>
        <source>time of number %1 of %2</source>
        <translation>%2 个中第 %1 个的时间</translation>
    </message>
    <message>
        <source>Allowed beyond wire time</source>
        <translation>线路时间之外允许</translation>
    </message>
    <message>
        <source>How long the panel waits for an answer, beyond what both frames need on the wire, before it counts as missing. It follows what this controller and adapter need, and doubles when nothing comes.</source>
        <translation>除两帧在线路上所需的时间外，面板再等待多久才认定应答缺失。它随此控制器和适配器的实际需要而定，没有应答时加倍。</translation>
    </message>
    <message>
        <source>%1 × the time within which 99 % of the last answers began, from %2 to %3 ms</source>
        <translation>%1 × 最近应答的 99 % 开始前所用的时间，限于 %2 至 %3 ms</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Of all values recorded in the time that is shown (n = %1).</source>
        <translation>所示时段内记录的全部数值（n = %1）的平均值。</translation>
    </message>
    <message>
        <source>sum of the values / n</source>
        <translation>数值之和 / n</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>离散度</translation>
    </message>
    <message>
        <source>Standard deviation: about two thirds of the values are closer to the mean than this.</source>
        <translation>标准差：约三分之二的数值与平均值之差小于此值。</translation>
    </message>
    <message>
        <source>√(sum of (value − mean)² / (n − 1))</source>
        <translation>√((数值 − 平均值)² 之和 / (n − 1))</translation>
    </message>
    <message>
        <source>Lowest and highest</source>
        <translation>最低和最高</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>lowest, highest</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Single values. The curve is the mean of each column, the pale band around it goes from the lowest to the highest value of that column.</source>
        <translation>均为单个数值。曲线是每一列的平均值，其周围的浅色带从该列的最低值到最高值。</translation>
    </message>
    <message>
        <source>the lowest … the highest of the n values</source>
        <translation>n 个数值中的最低值 … 最高值</translation>
    </message>
    <message>
        <source>Within the tolerance</source>
        <translation>公差内</translation>
    </message>
    <message>
        <source>Each bag is judged by the tolerance that held when it was made.</source>
        <translation>每个袋均按其生产时有效的公差判定。</translation>
    </message>
    <message>
        <source>bags whose deviation is not above the tolerance / n</source>
        <translation>偏差不超过公差的袋数 / n</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Mean at the cursor</source>
        <translation>光标处的平均值</translation>
    </message>
    <message>
        <source>The curves are drawn in columns of %1 each. In the one at the cursor the lowest value was %2, the highest %3.</source>
        <translation>曲线按每列 %1 绘制。光标所在一列的最低值为 %2，最高值为 %3。</translation>
    </message>
    <message>
        <source>sum of the column&apos;s values / their number</source>
        <translation>该列数值之和 / 个数</translation>
    </message>
    <message>
        <source>%1 of 100 answers took no longer than this.</source>
        <translation>每 100 个应答中有 %1 个不超过此时间。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FrameList</name>
    <message>
        <source>Sent at %1</source>
        <translation>发送于 %1</translation>
    </message>
    <message>
        <source>Received at %1</source>
        <translation>接收于 %1</translation>
    </message>
    <message>
        <source>link frames</source>
        <translation>线路帧</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Homing</name>
    <message>
        <source>Homed</source>
        <translation>已回零</translation>
    </message>
    <message>
        <source>Upper position known</source>
        <translation>上位已知</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>Upper position not known</source>
        <translation>上位未知</translation>
    </message>
    <message>
        <source>Needs no homing</source>
        <translation>无需回零</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>The knife turns slowly forward to the index mark of its shaft, brakes and returns to it: that is 0°. Keep hands away from the knife. Start does this by itself when it is needed.</source>
        <translation>刀缓慢正转到刀轴的零位标记，制动后返回该处，即 0°。手不要靠近刀具。需要时，启动会自动完成回零。</translation>
    </message>
    <message>
        <source>The axis turns slowly forward to the index mark of its motor, brakes and returns to it: that is position 0. Start does this by itself when it is needed.</source>
        <translation>轴缓慢正转到电机的零位标记，制动后返回该处，即位置 0。需要时，启动会自动完成回零。</translation>
    </message>
    <message>
        <source>Moves begin where the axis stands, so nothing has to be homed. Home turns slowly to the index mark of the motor and calls it position 0.</source>
        <translation>运动从轴当前所在位置开始，因此无需回零。按“回零”后，轴缓慢转到电机的零位标记，并将其作为位置 0。</translation>
    </message>
    <message>
        <source>Nothing moves: the place where the ram stands now becomes its upper position, from which all depths are measured. Jog it there first. A wrong place makes every stroke wrong.</source>
        <translation>不会产生运动：压头当前所在位置将成为上位，所有深度都从这里量起。请先将压头点动到该位置。位置不对，每次压装都会出错。</translation>
    </message>
    <message>
        <source>What homing does depends on the program, and the controller has none.</source>
        <translation>回零动作取决于程序，而控制器中没有程序。</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Set as top position</source>
        <translation>设为上位</translation>
    </message>
    <message>
        <source>Looking for the index mark …</source>
        <translation>正在寻找零位标记…</translation>
    </message>
    <message>
        <source>The last homing has found the index mark.</source>
        <translation>上次回零已找到零位标记。</translation>
    </message>
    <message>
        <source>The place where the ram stood has become its upper position.</source>
        <translation>压头所在位置已设为上位。</translation>
    </message>
    <message>
        <source>The last homing was stopped before it ended.</source>
        <translation>上次回零在完成之前被停止。</translation>
    </message>
    <message>
        <source>The last homing has failed, see the alarm: no index mark came within two revolutions, or the axis did not follow.</source>
        <translation>上次回零失败，请查看报警：两转之内没有出现零位标记，或轴没有跟随。</translation>
    </message>
    <message>
        <source>The line was lost while homing: what came of it is not known.</source>
        <translation>回零期间线路中断：结果未知。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::IoList</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 个脉冲</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Encoder of the axis</source>
        <translation>轴编码器</translation>
    </message>
    <message>
        <source>Encoder, speed</source>
        <translation>编码器速度</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Index mark</source>
        <translation>零位标记</translation>
    </message>
    <message>
        <source>not found yet</source>
        <translation>尚未找到</translation>
    </message>
    <message>
        <source>found, or not needed</source>
        <translation>已找到或不需要</translation>
    </message>
    <message>
        <source>Heartbeat of the panel</source>
        <translation>面板心跳</translation>
    </message>
    <message>
        <source>no. %1</source>
        <comment>of a heartbeat</comment>
        <translation>第 %1 号</translation>
    </message>
    <message>
        <source>Pulses to the axis</source>
        <translation>送往轴的脉冲</translation>
    </message>
    <message>
        <source>Pulses sent</source>
        <translation>已发送脉冲</translation>
    </message>
    <message>
        <source>Sent minus encoder</source>
        <translation>发送减编码器</translation>
    </message>
    <message>
        <source>Mark sensor</source>
        <translation>色标传感器</translation>
    </message>
    <message>
        <source>%1 marks</source>
        <translation>%1 个色标</translation>
    </message>
    <message>
        <source>Product eye</source>
        <translation>产品光电</translation>
    </message>
    <message>
        <source>%1 products laid</source>
        <translation>已放置 %1 个产品</translation>
    </message>
    <message>
        <source>Encoder of the film</source>
        <translation>膜编码器</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>follows</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>slows down</source>
        <translation>减速中</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>gains speed</source>
        <translation>加速中</translation>
    </message>
    <message>
        <source>Pulses to the film</source>
        <translation>送往膜轴的脉冲</translation>
    </message>
    <message>
        <source>Knife with the film</source>
        <translation>刀随膜运动</translation>
    </message>
    <message>
        <source>Film, sent minus encoder</source>
        <translation>膜：发送减编码器</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Jog</name>
    <message>
        <source>towards the part</source>
        <translation>朝向工件</translation>
    </message>
    <message>
        <source>away from the part</source>
        <translation>离开工件</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>未连接到控制器。</translation>
    </message>
    <message>
        <source>The machine is running. Stop it first.</source>
        <translation>机器正在运行。请先停止。</translation>
    </message>
    <message>
        <source>The machine is stopping. Wait until it stands.</source>
        <translation>机器正在停止。请等它停稳。</translation>
    </message>
    <message>
        <source>The axis is homing. Wait until it stands.</source>
        <translation>轴正在回零。请等它停稳。</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>控制器处于故障状态。请先复位故障。</translation>
    </message>
    <message>
        <source>The state of the controller is not known.</source>
        <translation>控制器的状态未知。</translation>
    </message>
    <message>
        <source>Stop has ended it. Let the key go before you jog again.</source>
        <translation>点动已被停止键结束。请先松开按键再点动。</translation>
    </message>
    <message>
        <source>Two keys at once: nothing moves. Let both go.</source>
        <translation>同时按下了两个键：不会运动。请都松开。</translation>
    </message>
    <message>
        <source>Let the key go before you jog again.</source>
        <translation>请先松开按键再点动。</translation>
    </message>
    <message>
        <source>The controller does not move. A press does not go on against its force.</source>
        <translation>控制器没有动作。压机在受力时不会继续前进。</translation>
    </message>
    <message>
        <source>The controller does not move. Let the key go and try again.</source>
        <translation>控制器没有动作。请松开按键后再试。</translation>
    </message>
    <message>
        <source>Forward, as long as you hold the key.</source>
        <translation>按住期间正向运动。</translation>
    </message>
    <message>
        <source>In reverse, as long as you hold the key.</source>
        <translation>按住期间反向运动。</translation>
    </message>
    <message>
        <source>Hold a key: the knife turns while your finger is on it. The film stands, and the next start homes first.</source>
        <translation>按住按键：手指按住期间刀转动。膜不动，下次启动会先回零。</translation>
    </message>
    <message>
        <source>Hold a key: the ram moves while your finger is on it.</source>
        <translation>按住按键：手指按住期间压头运动。</translation>
    </message>
    <message>
        <source>Hold a key: the axis moves while your finger is on it.</source>
        <translation>按住按键：手指按住期间轴运动。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::KnotFiles</name>
    <message>
        <source>%1 can only be read. Unlock the stick or choose another place.</source>
        <translation>%1 只能读取。请解除 U 盘的写保护，或选择其他位置。</translation>
    </message>
    <message>
        <source>A new file %1 will be written.</source>
        <translation>将写入新文件 %1。</translation>
    </message>
    <message>
        <source>%1 knots · %2 · %3</source>
        <comment>number, date, place</comment>
        <translation>%1 个型值点 · %2 · %3</translation>
    </message>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>无法使用 · %1 · %2</translation>
    </message>
    <message>
        <source>Line %1: %2 Correct the file and look again.</source>
        <comment>%2: whole sentence</comment>
        <translation>第 %1 行：%2请改正文件后重新查找。</translation>
    </message>
    <message>
        <source>%1 Correct the file and look again.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1请改正文件后重新查找。</translation>
    </message>
    <message>
        <source>%1 knots, slave %2 to %3 mm, take the place of those of the recipe. Undo brings these back.</source>
        <translation>%1 个型值点，从轴 %2 至 %3 mm，将取代配方中的型值点。可用“撤销”恢复。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>%1 · can only be read</source>
        <translation>%1 · 只读</translation>
    </message>
    <message>
        <source>Written: %1. The stick can be taken out now.</source>
        <translation>已写入：%1。现在可以拔出U盘。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::KnotModel</name>
    <message>
        <source>Knot %1, master</source>
        <translation>型值点 %1，主轴</translation>
    </message>
    <message>
        <source>Knot %1, slave</source>
        <translation>型值点 %1，从轴</translation>
    </message>
    <message>
        <source>The cycle closes smoothly.</source>
        <translation>周期平滑闭合。</translation>
    </message>
    <message>
        <source>The cycle closes smoothly and advances by %1 mm.</source>
        <translation>周期平滑闭合，每周期前进 %1 mm。</translation>
    </message>
    <message>
        <source>Where the cycle closes: position jumps by %1 mm, speed by %2 mm/°, acceleration by %3 mm/°².</source>
        <translation>周期闭合处：位置跳变 %1 mm，速度跳变 %2 mm/°，加速度跳变 %3 mm/°²。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SimulatedFaults</name>
    <message>
        <source>Late answers</source>
        <translation>迟到的应答</translation>
    </message>
    <message>
        <source>One and a half time-outs late: they meet the next question.</source>
        <translation>迟到一个半超时时间，会碰上下一个询问。</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Questions and answers that never arrive.</source>
        <translation>永远收不到的询问和应答。</translation>
    </message>
    <message>
        <source>Corrupted answers</source>
        <translation>损坏的应答</translation>
    </message>
    <message>
        <source>Flipped bits and answers cut short.</source>
        <translation>位翻转，或应答被截短。</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Random bytes behind the answers.</source>
        <translation>应答之后的随机字节。</translation>
    </message>
    <message>
        <source>A second master</source>
        <translation>第二个主站</translation>
    </message>
    <message>
        <source>Its right answers stand where the panel&apos;s are expected.</source>
        <translation>它的正确应答出现在面板等待应答的位置。</translation>
    </message>
    <message>
        <source>Other devices answer</source>
        <translation>其他设备应答</translation>
    </message>
    <message>
        <source>Wrong unit, wrong function, wrong length.</source>
        <translation>单元号、功能码或长度错误。</translation>
    </message>
    <message>
        <source>Busy controller</source>
        <translation>控制器忙</translation>
    </message>
    <message>
        <source>It refuses three questions in a row.</source>
        <translation>连续拒绝三次询问。</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>静默</translation>
    </message>
    <message>
        <source>Nothing passes for two seconds.</source>
        <translation>两秒内没有任何数据通过。</translation>
    </message>
    <message>
        <source>Unplugged adapter</source>
        <translation>拔出适配器</translation>
    </message>
    <message>
        <source>The port is gone for two seconds.</source>
        <translation>端口消失两秒。</translation>
    </message>
    <message>
        <source>Restarts of the controller</source>
        <translation>控制器重启</translation>
    </message>
    <message>
        <source>Silence, then power-up from what was saved. The machine stops.</source>
        <translation>先静默，再以已保存的内容上电。机器会停止。</translation>
    </message>
    <message>
        <source>Another register map</source>
        <translation>另一种寄存器表</translation>
    </message>
    <message>
        <source>Seen when the panel connects anew, after another fault.</source>
        <translation>其他故障后面板重新连接时才会出现。</translation>
    </message>
    <message>
        <source>No faults: the line is as good as it gets.</source>
        <translation>没有故障：线路处于最佳状态。</translation>
    </message>
    <message>
        <source>Active: %1</source>
        <translation>已启用：%1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>The simulated controller refused the fault: %1</source>
        <translation>模拟控制器拒绝了该故障：%1</translation>
    </message>
    <message>
        <source>Faults are for the simulated controller only.</source>
        <translation>故障仅适用于模拟控制器。</translation>
    </message>
    <message>
        <source>The simulated controller is not running. Try again when it is connected.</source>
        <translation>模拟控制器未运行。请在连接后重试。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LineFigures</name>
    <message>
        <source>Requests</source>
        <translation>请求</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Asked again</source>
        <translation>重复询问</translation>
    </message>
    <message>
        <source>Bytes dropped</source>
        <translation>丢弃的字节</translation>
    </message>
    <message>
        <source>Share of the wire&apos;s limit</source>
        <translation>占线路极限的比例</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Wrong checksum</source>
        <translation>校验和错误</translation>
    </message>
    <message>
        <source>Damaged frame</source>
        <translation>帧损坏</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>被控制器拒绝</translation>
    </message>
    <message>
        <source>Port gone</source>
        <translation>端口消失</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>Half of all within</source>
        <translation>半数不超过</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % 不超过</translation>
    </message>
    <message>
        <source>99 % within</source>
        <translation>99 % 不超过</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最长</translation>
    </message>
    <message>
        <source>Requests answered</source>
        <translation>已应答的请求</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>link figures</source>
        <translation>线路数据</translation>
    </message>
    <message>
        <source>link 24 hours</source>
        <translation>线路24小时</translation>
    </message>
    <message>
        <source>Foreign answer</source>
        <translation>不相干的应答</translation>
    </message>
    <message>
        <source>Allowed beyond wire time</source>
        <translation>线路时间之外允许</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LinkDoctor</name>
    <message>
        <source>The machine is moving. Diagnosis and search close the connection, and the controller would miss this panel. Stop the machine first.</source>
        <translation>机器正在运动。诊断和搜索会关闭连接，控制器会收不到面板的心跳。请先停机。</translation>
    </message>
    <message>
        <source>A Stop waits for the connection to come back. It goes first.</source>
        <translation>有一个停止命令在等待连接恢复，它优先。</translation>
    </message>
    <message>
        <source>A download is under way. Wait for its end, or cancel it.</source>
        <translation>正在下载。请等它结束，或取消它。</translation>
    </message>
    <message>
        <source>Trying %1: %2</source>
        <comment>port, settings</comment>
        <translation>正在尝试 %1：%2</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>模拟控制器</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>port, settings</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Diagnose asks the port in use a few questions. Search tries every port, baud rate, parity and unit number, which may take long. Both only read, and close the connection meanwhile.</source>
        <translation>诊断向正在使用的端口提几个问题。搜索会尝试所有端口、波特率、校验和站号，可能需要很久。两者都只读取，期间连接关闭。</translation>
    </message>
    <message>
        <source>Searching. The connection comes back after it.</source>
        <translation>正在搜索。之后连接会恢复。</translation>
    </message>
    <message>
        <source>Asking the port in use. The connection comes back after it.</source>
        <translation>正在询问使用中的端口。之后连接会恢复。</translation>
    </message>
    <message>
        <source>A controller answers: %1.</source>
        <translation>有控制器应答：%1。</translation>
    </message>
    <message>
        <source>The connection in use works: %1.</source>
        <translation>使用中的连接正常：%1。</translation>
    </message>
    <message>
        <source>Canceled. The connection comes back by itself.</source>
        <translation>已取消。连接会自行恢复。</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug in the adapter and search again.</source>
        <translation>此计算机没有串口。请插入适配器后再搜索。</translation>
    </message>
    <message>
        <source>No controller was found. This is what was seen:</source>
        <translation>没有找到控制器。看到的情况如下：</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>port, what was found</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Controller</name>
    <message>
        <source>Searching</source>
        <translation>正在查找</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>No connection</source>
        <translation>无连接</translation>
    </message>
    <message>
        <source>Wrong device</source>
        <translation>设备不符</translation>
    </message>
    <message>
        <source>Port problem</source>
        <translation>端口问题</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>没有连接到控制器。</translation>
    </message>
    <message>
        <source>The state of the controller is not known.</source>
        <translation>控制器状态未知。</translation>
    </message>
    <message>
        <source>The line is back. The controller has restarted meanwhile.</source>
        <translation>连接已恢复。期间控制器曾重新启动。</translation>
    </message>
    <message>
        <source>The line is back. The controller has got another program meanwhile.</source>
        <translation>连接已恢复。期间控制器换了另一个程序。</translation>
    </message>
    <message>
        <source>The line is back. Before: %1. Now: %2.</source>
        <comment>states of the machine</comment>
        <translation>连接已恢复。之前：%1。现在：%2。</translation>
    </message>
    <message>
        <source>The line is back: Stop was sent and the controller has taken it.</source>
        <translation>连接已恢复：停止命令已发送，控制器已接受。</translation>
    </message>
    <message>
        <source>Stop was withdrawn: it is not sent any more.</source>
        <translation>停止命令已撤回，不会再发送。</translation>
    </message>
    <message>
        <source>Stop was not sent: it was meant for the machine that was connected before.</source>
        <translation>停止命令未发送：它是给之前连接的那台机器的。</translation>
    </message>
    <message>
        <source>The line is back: Stop was sent, but the machine was no longer running.</source>
        <translation>连接已恢复：停止命令已发送，但机器已不在运行。</translation>
    </message>
    <message>
        <source>Stop was sent and its answer is awaited.</source>
        <translation>停止命令已发送，正在等待应答。</translation>
    </message>
    <message>
        <source>Stop waits for the line – it is sent as soon as the line is back.</source>
        <translation>停止命令正在等待连接，连接恢复后立即发送。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MarkWizard</name>
    <message>
        <source>Cut behind its mark</source>
        <translation>切断在色标之后</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>与控制器没有连接。</translation>
    </message>
    <message>
        <source>The controller does not run a packing machine&apos;s program.</source>
        <translation>控制器没有运行包装机的程序。</translation>
    </message>
    <message>
        <source>Start the machine; this step goes on while it runs.</source>
        <translation>请启动机器；运行中此步骤才会继续。</translation>
    </message>
    <message>
        <source>The cuts do not follow the marks. Switch that on first.</source>
        <translation>切断未跟踪色标。请先打开色标跟踪。</translation>
    </message>
    <message>
        <source>Waiting until the cuts have met the marks …</source>
        <translation>正在等待切断与色标对齐…</translation>
    </message>
    <message>
        <source>Asking the controller …</source>
        <translation>正在询问控制器…</translation>
    </message>
    <message>
        <source>The corrected distance is outside the controller&apos;s range. Measure again.</source>
        <translation>修正后的距离超出控制器的范围。请重新测量。</translation>
    </message>
    <message>
        <source>The distance is written, but the cuts of the last bags lay %1 from their marks on average. Look at gains and film before measuring again.</source>
        <translation>距离已写入，但最近几袋的切断平均偏离色标 %1。重新测量前请检查增益和薄膜。</translation>
    </message>
    <message>
        <source>That bag has been measured already; wait for the next one.</source>
        <translation>这一袋已经量过；请等下一袋。</translation>
    </message>
    <message>
        <source>No bag has been cut yet.</source>
        <translation>还没有切出袋子。</translation>
    </message>
    <message>
        <source>The simulated machine cannot be measured now.</source>
        <translation>现在无法测量模拟机器。</translation>
    </message>
    <message>
        <source>The controller works with the new distance, and the cuts of the last bags lie within %1 of where it wants them. Measure one more bag to be sure. Without Save the controller forgets it at power-off.</source>
        <translation>控制器已使用新距离，最近几袋的切断与目标位置相差不超过 %1。请再量一袋确认。不保存则断电后丢失。</translation>
    </message>
    <message>
        <source>When every cut lies off its mark by the same distance, the controller is wrong about how far the mark sensor is from the knife. This finds it out: the machine cuts a few bags, you measure how far their cuts lie behind their marks, and the distance is corrected. Nothing is changed before you confirm.</source>
        <translation>如果每次切断都以相同距离偏离色标，说明控制器中色标传感器到切刀的距离不对。此向导用来找出它：机器切出几袋，您测量切断在色标后多远，再修正距离。确认之前不会改变任何值。</translation>
    </message>
    <message>
        <source>%1 of %2 bags cut. Keep them in order and do not pull them.</source>
        <translation>已切 %1 / %2 袋。请按顺序放好，不要拉伸。</translation>
    </message>
    <message>
        <source>The measurements are %1 apart. Are they all from the same edge of the mark?</source>
        <translation>各次测量相差 %1。都是从色标的同一边量起的吗？</translation>
    </message>
    <message>
        <source>This becomes the distance from the mark sensor to the knife. The cuts move over the next bags.</source>
        <translation>这将成为色标传感器到切刀的距离。切断位置将在随后几袋中移动。</translation>
    </message>
    <message>
        <source>Writing, and reading back …</source>
        <translation>正在写入并回读…</translation>
    </message>
    <message>
        <source>Written and read back. The new distance reaches the knife with the film: bag %1 of at most %2.</source>
        <translation>已写入并回读。新距离随薄膜到达切刀：第 %1 袋，最多 %2 袋。</translation>
    </message>
    <message>
        <source>Measure from the printed mark to the cut: positive when the film passes the mark first and the cut comes behind it, negative when the cut comes before its mark. The mean of up to %1 bags counts.</source>
        <translation>从印刷色标量到切断处：先经过色标、切断在其后为正；切断在色标之前为负。最多取 %1 袋的平均值。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterDirection</name>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>没有连接到控制器。</translation>
    </message>
    <message>
        <source>This controller cannot turn its master round. Update its firmware.</source>
        <translation>此控制器不能使主轴换向。请更新其固件。</translation>
    </message>
    <message>
        <source>Asking the controller …</source>
        <translation>正在询问控制器…</translation>
    </message>
    <message>
        <source>Turning to backward …</source>
        <translation>正在换向为反转…</translation>
    </message>
    <message>
        <source>Turning to forward …</source>
        <translation>正在换向为正转…</translation>
    </message>
    <message>
        <source>starts backward</source>
        <translation>启动后反转</translation>
    </message>
    <message>
        <source>starts forward</source>
        <translation>启动后正转</translation>
    </message>
    <message>
        <source>set to backward</source>
        <translation>已设为反转</translation>
    </message>
    <message>
        <source>set to forward</source>
        <translation>已设为正转</translation>
    </message>
    <message>
        <source>runs backward</source>
        <translation>正在反转</translation>
    </message>
    <message>
        <source>runs forward</source>
        <translation>正在正转</translation>
    </message>
    <message>
        <source>The direction of the master</source>
        <translation>主轴方向</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingFields</name>
    <message>
        <source>Cuts follow the marks</source>
        <translation>切断跟踪色标</translation>
    </message>
    <message>
        <source>Phase gain: share taken for slip</source>
        <translation>相位增益：误差中视为打滑的份额</translation>
    </message>
    <message>
        <source>Length gain: share taken for length</source>
        <translation>长度增益：误差中视为长度的份额</translation>
    </message>
    <message>
        <source>Mark sensor to knife</source>
        <translation>色标传感器到切刀</translation>
    </message>
    <message>
        <source>Cut behind its mark</source>
        <translation>切断在色标之后</translation>
    </message>
    <message>
        <source>Window around an expected mark, ±</source>
        <translation>预期色标的窗口，±</translation>
    </message>
    <message>
        <source>Missing marks in a row to stop</source>
        <translation>连续缺少多少色标时停机</translation>
    </message>
    <message>
        <source>Phase limit: most shift of a cut</source>
        <translation>相位限值：每袋切断的最大移动</translation>
    </message>
    <message>
        <source>Length limit: most change of a bag</source>
        <translation>长度限值：每袋薄膜的最大变化</translation>
    </message>
    <message>
        <source>Length trim without marks</source>
        <translation>不跟踪色标时的长度微调</translation>
    </message>
    <message>
        <source>Knife stays open over a product</source>
        <translation>有产品时切刀保持张开</translation>
    </message>
    <message>
        <source>Clearance on both sides of a cut</source>
        <translation>切断两侧无产品的距离</translation>
    </message>
    <message>
        <source>Skipped cuts in a row to stop</source>
        <translation>连续跳过多少次切断时停机</translation>
    </message>
    <message>
        <source>Film waits for a missing product</source>
        <translation>缺产品时薄膜等待</translation>
    </message>
    <message>
        <source>Products are laid before the knife</source>
        <translation>产品落点，切刀之前</translation>
    </message>
    <message>
        <source>Product eye before that place</source>
        <translation>产品光电眼，落点之前</translation>
    </message>
    <message>
        <source>Product distance on the infeed</source>
        <translation>进料上产品的间距</translation>
    </message>
    <message>
        <source>Infeed motor: pulses per product</source>
        <translation>进料电机：每个产品的脉冲数</translation>
    </message>
    <message>
        <source>Film motor: film per revolution</source>
        <translation>薄膜电机：每转薄膜长度</translation>
    </message>
    <message>
        <source>Film motor: pulses per revolution</source>
        <translation>薄膜电机：每转脉冲数</translation>
    </message>
    <message>
        <source>Writing %1: %2 …</source>
        <translation>正在写入 %1：%2…</translation>
    </message>
    <message>
        <source>%1: %2, read back from the controller.</source>
        <translation>%1：%2，已从控制器回读。</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>%1 · suggestion after %2 bags that follow their marks, %3 so far</source>
        <translation>%1 · 跟踪色标 %2 袋后给出建议，目前 %3 袋</translation>
    </message>
    <message>
        <source>%1 · film slips %2 mm a bag, sensor scatters %3 mm (%4 bags)</source>
        <translation>%1 · 薄膜每袋打滑 %2 mm，传感器离散 %3 mm（%4 袋）</translation>
    </message>
    <message>
        <source>%1 · no suggestion: the marks do not scatter (%2 bags)</source>
        <translation>%1 · 无建议：色标位置没有离散（%2 袋）</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingLine</name>
    <message>
        <source>Film waits for a product</source>
        <translation>薄膜等待产品</translation>
    </message>
    <message>
        <source>Knife stays open: product across</source>
        <translation>切刀保持张开：有产品横在切刀处</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingSetup</name>
    <message>
        <source>The controller tells nothing of a packing machine: connect it and download a cutter&apos;s recipe.</source>
        <translation>控制器没有包装机的数据：请连接并下载切刀配方。</translation>
    </message>
    <message>
        <source>Waiting: the marks are measured while the film runs.</source>
        <translation>等待中：薄膜运行时才测量色标。</translation>
    </message>
    <message>
        <source>%1 of %2 marks measured …</source>
        <translation>已测量 %1 / %2 个色标…</translation>
    </message>
    <message>
        <source>Measures the distances between the next %1 marks. The machine keeps running.</source>
        <translation>测量随后 %1 个色标的间距。机器继续运行。</translation>
    </message>
    <message>
        <source>Start the machine: the marks are measured while the film runs, with or without following them.</source>
        <translation>请启动机器：薄膜运行时测量色标，跟踪与否均可。</translation>
    </message>
    <message>
        <source>The marks are %1 mm apart (± %2 mm); the recipe cuts %3 mm. That is more than the length limit allows: this film does not fit this recipe.</source>
        <translation>色标间距 %1 mm（± %2 mm）；配方切 %3 mm。差值超过长度限值：此薄膜与此配方不符。</translation>
    </message>
    <message>
        <source>The marks are %1 mm apart (± %2 mm); the recipe cuts %3 mm.</source>
        <translation>色标间距 %1 mm（± %2 mm）；配方切 %3 mm。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramProof</name>
    <message>
        <source>Not possible now: there is no connection to the controller.</source>
        <translation>暂时无法进行：没有连接到控制器。</translation>
    </message>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>控制器没有程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The connection is lost; the comparison goes on when it is back.</source>
        <translation>连接已断开；恢复后比较会继续。</translation>
    </message>
    <message>
        <source>Reading the table back from the controller …</source>
        <translation>正在从控制器读回程序表…</translation>
    </message>
    <message>
        <source>Reads every register of the table back and compares it. The machine may run meanwhile.</source>
        <translation>读回程序表的每个寄存器并逐一比较。期间机器可以运行。</translation>
    </message>
    <message>
        <source>what this panel downloaded</source>
        <translation>本面板下载的内容</translation>
    </message>
    <message>
        <source>the table computed anew from its recipe</source>
        <translation>按其配方重新计算的程序表</translation>
    </message>
    <message>
        <source>the controller&apos;s own checksum</source>
        <translation>控制器自己的校验和</translation>
    </message>
    <message>
        <source>Equal: the table of generation %1, read back, has %2. CRC-32 %3.</source>
        <comment>%2: &quot;the controller&apos;s own checksum&quot;</comment>
        <translation>一致：读回的第 %1 代程序表与%2相符。CRC-32 %3。</translation>
    </message>
    <message>
        <source>Equal: all %1 registers of generation %2 are %3. CRC-32 %4.</source>
        <comment>%3: for example &quot;what this panel downloaded&quot;</comment>
        <translation>一致：第 %2 代的全部 %1 个寄存器与%3相符。CRC-32 %4。</translation>
    </message>
    <message>
        <source>The controller&apos;s program changed during the comparison. Compare again.</source>
        <translation>比较期间控制器的程序已更换。请重新比较。</translation>
    </message>
    <message>
        <source>Canceled. Nothing was found out.</source>
        <translation>已取消，没有得出结果。</translation>
    </message>
    <message>
        <source>Different: read back the table has CRC-32 %1, the controller says %2. Download the recipe again.</source>
        <translation>不一致：读回的程序表 CRC-32 为 %1，控制器报告为 %2。请重新下载配方。</translation>
    </message>
    <message>
        <source>first %1: %2 instead of %3</source>
        <comment>register: its value, expected value</comment>
        <translation>第一个是 %1：为 %2，应为 %3</translation>
    </message>
    <message>
        <source>Different: 1 of %1 registers is not %2, %3. Download the recipe again.</source>
        <translation>不一致：%1 个寄存器中有 1 个与%2不符，%3。请重新下载配方。</translation>
    </message>
    <message>
        <source>Different: %1 of %2 registers are not %3, %4. Download the recipe again.</source>
        <translation>不一致：%2 个寄存器中有 %1 个与%3不符，%4。请重新下载配方。</translation>
    </message>
    <message>
        <source>Not compared: there is no connection to the controller.</source>
        <translation>未比较：没有连接到控制器。</translation>
    </message>
    <message>
        <source>Not compared: another comparison is under way.</source>
        <translation>未比较：另一个比较正在进行。</translation>
    </message>
    <message>
        <source>Not compared. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>未比较。%1</translation>
    </message>
    <message>
        <source>register %1 of the rows</source>
        <translation>行数据的第 %1 个寄存器</translation>
    </message>
    <message>
        <source>no program</source>
        <translation>没有程序</translation>
    </message>
    <message>
        <source>generation %1, CRC-32 %2</source>
        <translation>第 %1 代，CRC-32 %2</translation>
    </message>
    <message>
        <source>%1 · v%2, generation %3, CRC-32 %4</source>
        <translation>%1 · 第%2版，第 %3 代，CRC-32 %4</translation>
    </message>
    <message>
        <source>nothing: after a loss of power there is no program</source>
        <translation>无：断电后没有程序</translation>
    </message>
    <message>
        <source>the same: it is there after a loss of power</source>
        <translation>相同：断电后仍保留</translation>
    </message>
    <message>
        <source>another one, CRC-32 %1: it is back after a loss of power</source>
        <translation>另一个程序，CRC-32 %1：断电后恢复为它</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeFiles</name>
    <message>
        <source>%1 · %2 · %3</source>
        <comment>what it is, date, place</comment>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>不能使用 · %1 · %2</translation>
    </message>
    <message>
        <source>%1 Correct the file and look again.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 请更正文件后重新查找。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Recipes</name>
    <message>
        <source>%1 was taken over as %2, version %3.</source>
        <comment>file, recipe</comment>
        <translation>%1 已导入为 %2，第%3版。</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>date, person</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>%1 · version %2, %3</source>
        <comment>kind of program, number, when it was saved</comment>
        <translation>%1 · 第%2版，%3</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>Too long: the controller keeps %1 letters of a name, or a third as many Chinese ones.</source>
        <translation>太长：控制器最多保存 %1 个字母，汉字为其三分之一。</translation>
    </message>
    <message>
        <source>There is a recipe of this name already.</source>
        <translation>已有同名配方。</translation>
    </message>
    <message>
        <source>Saved: %1, version %2.</source>
        <translation>已保存：%1，第%2版。</translation>
    </message>
    <message>
        <source>%1 is new and open, with usual values. Set yours on the page Motion.</source>
        <translation>%1 已新建并打开，采用常用值。请在“运动”页设置您的数值。</translation>
    </message>
    <message>
        <source>%1 is a copy and open.</source>
        <translation>%1 是副本，已打开。</translation>
    </message>
    <message>
        <source>A deleted recipe has the name %1. Choose another name.</source>
        <translation>已删除的配方占用名称 %1。请另选名称。</translation>
    </message>
    <message>
        <source>Renamed %1 to %2.</source>
        <translation>%1 现在名为 %2。</translation>
    </message>
    <message>
        <source>%1 was deleted. Its versions are kept.</source>
        <translation>%1 已删除，其各版本仍保留。</translation>
    </message>
    <message>
        <source>%1 · v%2</source>
        <translation>%1 · 第%2版</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>第%1版</translation>
    </message>
    <message>
        <source>It becomes a new recipe, %1. The data of this machine stay as they are.</source>
        <translation>将成为新配方 %1。本机数据保持不变。</translation>
    </message>
    <message>
        <source>It is the same as %1, version %2; nothing changes.</source>
        <translation>与 %1 第%2版相同，不会改变。</translation>
    </message>
    <message>
        <source>It becomes version %2 of %1; the versions before are kept.</source>
        <translation>将成为 %1 的第%2版，以前的版本均保留。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::DatabaseService</name>
    <message>
        <source>%1 Until then nothing is kept over a restart.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1 在此之前，重新启动后不会保留任何内容。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was damaged. It goes on with its last good copy; the damaged file is kept as %1.</source>
        <translation>面板的存储曾损坏，现使用最后一份完好的副本继续工作；损坏的文件保留为 %1。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was damaged and there was no copy. A new, empty database was created; the damaged file is kept as %1.</source>
        <translation>面板的存储已损坏且没有副本，现从空白开始；损坏的文件保留为 %1。</translation>
    </message>
    <message>
        <source>The backup has been restored. What was there before is kept in %1.</source>
        <translation>备份已恢复。之前的内容保存在 %1。</translation>
    </message>
    <message>
        <source>The restore could not be finished: %1. It is tried again at the next start.</source>
        <translation>恢复未能完成：%1。下次启动时将再次尝试。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was missing or empty. The last good copy was put in its place: what was saved after the last start is lost.</source>
        <translation>面板的存储丢失或为空，已用最近的完好副本代替：上次启动之后保存的内容已丢失。</translation>
    </message>
    <message>
        <source>The panel&apos;s memory was missing or empty, and there was no good copy. A new, empty one was created. Restore a backup.</source>
        <translation>面板的存储丢失或为空，且没有完好的副本，已新建空白存储。请恢复备份。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RegisterInspector</name>
    <message>
        <source>All groups</source>
        <translation>所有组</translation>
    </message>
    <message>
        <source>Tap a register to read more about it, or to write it.</source>
        <translation>点按一个寄存器查看更多信息，或写入它。</translation>
    </message>
    <message>
        <source>Can be written: %1 to %2, by default %3.</source>
        <translation>可写：%1 到 %2，默认 %3。</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>没有连接到控制器。</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>正在写入 %1…</translation>
    </message>
    <message>
        <source>Written, and read back from the controller: %1.</source>
        <translation>已写入，并从控制器读回：%1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RegisterModel</name>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ReportFiles</name>
    <message>
        <source>%1 can only be read. Unlock the stick or choose another place.</source>
        <translation>%1 只能读取。请解除 U 盘的写保护，或选择其他位置。</translation>
    </message>
    <message>
        <source>New files will be written to %1.</source>
        <translation>新文件将写入 %1。</translation>
    </message>
    <message>
        <source>%1 · can only be read</source>
        <translation>%1 · 只读</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Written: %1. The stick can be taken out now.</source>
        <translation>已写入：%1。现在可以拔出U盘。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ServiceBundle</name>
    <message>
        <source>CamPanel service %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel 服务 %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Settings</name>
    <message>
        <source>Unit</source>
        <translation>站号</translation>
    </message>
    <message>
        <source>Bag tolerance ±</source>
        <translation>袋长允差 ±</translation>
    </message>
    <message>
        <source>Not permitted: add the user to the group &quot;%1&quot;.</source>
        <translation>无权限：请将用户加入“%1”组。</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing. Its last good copy is used. Check the settings.</source>
        <translation>设置文件已损坏或丢失。现使用其最后一份完好的副本。请检查设置。</translation>
    </message>
    <message>
        <source>The settings file was damaged and has no good copy. No controller is used. Choose one on the Settings page, under Connection.</source>
        <translation>设置文件已损坏，且没有完好的副本。当前不使用任何控制器。请在“设置”页的“通信”中选择。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Trends</name>
    <message>
        <source>bags</source>
        <translation>袋记录</translation>
    </message>
    <message>
        <source>trends</source>
        <translation>趋势</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Value</name>
    <message>
        <source>Enter a number.</source>
        <translation>请输入数字。</translation>
    </message>
    <message>
        <source>The smallest allowed value is %1.</source>
        <translation>最小允许值为 %1。</translation>
    </message>
    <message>
        <source>The largest allowed value is %1.</source>
        <translation>最大允许值为 %1。</translation>
    </message>
</context>
</TS>
