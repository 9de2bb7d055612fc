<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
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
        <source>Connection lost: %1 is gone. Plug the adapter in again; the panel reconnects by itself.</source>
        <translation>连接中断：%1 已不存在。请重新插入适配器，面板会自动重新连接。</translation>
    </message>
    <message>
        <source>Connection lost. Check the cable and the controller&apos;s power; the panel keeps trying on %1.</source>
        <translation>连接中断。请检查电缆和控制器电源，面板会继续在 %1 上重试。</translation>
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
        <source>Nobody answers on %1. Check cable, power, baud rate, parity and unit number.</source>
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
        <source>The controller runs this program.</source>
        <translation>控制器正在使用此程序。</translation>
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
        <source>The knife does not keep up with its command. Look for a jam, then reset the fault and home.</source>
        <translation>切刀跟不上指令。请检查是否卡住，然后复位故障并回零。</translation>
    </message>
    <message>
        <source>The table in the controller is damaged. Reset the fault and download the recipe again.</source>
        <translation>控制器中的数据表已损坏。请复位故障并重新下载配方。</translation>
    </message>
    <message>
        <source>No index mark was found while homing. Check drive and index sensor, then reset the fault.</source>
        <translation>回零时没有找到零位标记。请检查驱动器和零位传感器，然后复位故障。</translation>
    </message>
    <message>
        <source>The controller had not heard the panel for a while. Check the cable.</source>
        <translation>控制器有一段时间没有收到面板的信号。请检查电缆。</translation>
    </message>
    <message>
        <source>One of the two saved copies in the controller is damaged. Save the program again.</source>
        <translation>控制器中两份保存的副本有一份已损坏。请重新保存程序。</translation>
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
        <source>Knife radius, knives, pulses and gear change only at standstill. Stop the machine first.</source>
        <translation>刀半径、刀数、脉冲数和传动比只能在静止时更改。请先停机。</translation>
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
        <source>%1 rows, %2 pulses per cycle, %3 s</source>
        <translation>%1 行，每周期 %2 个脉冲，%3 s</translation>
    </message>
    <message>
        <source>Largest speed error: %1 mm/s (%2 %) at %3 s</source>
        <translation>最大速度误差：%1 mm/s（%2 %），在 %3 s</translation>
    </message>
    <message>
        <source>Largest frequency step: %1 Hz at %2 s</source>
        <translation>最大频率跳变：%1 Hz，在 %2 s</translation>
    </message>
    <message>
        <source>Largest position error: %1 pulses between rows, %2 inside</source>
        <translation>最大位置误差：行间 %1 个脉冲，行内 %2 个脉冲</translation>
    </message>
    <message>
        <source>Drift: none, the fraction of a pulse is carried from cycle to cycle</source>
        <translation>漂移：无，不足一个脉冲的余数逐周期累加</translation>
    </message>
    <message>
        <source>The paper&apos;s rule would be wrong by %1 pulses (%2 mm) in each bag</source>
        <translation>按论文的算法，每袋误差为 %1 个脉冲（%2 mm）</translation>
    </message>
    <message>
        <source>The controller cannot hold the value %1 (%2 to %3). Choose another one.</source>
        <translation>控制器不能存储数值 %1（范围 %2 到 %3）。请选择其他值。</translation>
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
        <source>The recipe could not be saved to %1: %2. The stored recipe is unchanged.</source>
        <translation>配方无法保存到 %1：%2。已存储的配方没有改变。</translation>
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
        <source>The paper&apos;s law: low acceleration; jerk steps at both ends.</source>
        <translation>论文采用的规律：加速度低，两端跃度突变。</translation>
    </message>
    <message>
        <source>No jerk step at the ends; a quarter more acceleration than the cubic.</source>
        <translation>两端无跃度突变，加速度比三次大四分之一。</translation>
    </message>
    <message>
        <source>The gentlest ends of all; highest acceleration in the middle.</source>
        <translation>两端最平缓，中间加速度最大。</translation>
    </message>
    <message>
        <source>Close to the cubic; jerk steps at both ends.</source>
        <translation>与三次相近，两端跃度突变。</translation>
    </message>
    <message>
        <source>No jerk step at the ends; a third more acceleration than the cubic.</source>
        <translation>两端无跃度突变，加速度比三次大三分之一。</translation>
    </message>
    <message>
        <source>Tolerates changing loads well; moderate acceleration.</source>
        <translation>能适应变化的负载，加速度适中。</translation>
    </message>
    <message>
        <source>Low jerk without steps at the ends; a third more acceleration than the cubic.</source>
        <translation>跃度低，两端无突变，加速度比三次大三分之一。</translation>
    </message>
    <message>
        <source>Lowest jerk, but stepped; acceleration has a sharp peak in the middle.</source>
        <translation>跃度最低但有突变，加速度在中间有尖峰。</translation>
    </message>
    <message>
        <source>Lowest acceleration, held for long; jerk steps at its four corners.</source>
        <translation>加速度最低且持续较长，四个拐点跃度突变。</translation>
    </message>
    <message>
        <source>Trapezoid with rounded corners; two shares to tune.</source>
        <translation>圆角梯形，有两个比例可调。</translation>
    </message>
    <message>
        <source>Fast at first, then gentle; acceleration steps at both ends.</source>
        <translation>先快后缓，两端加速度突变。</translation>
    </message>
    <message>
        <source>Quick first half; acceleration is zero at both ends.</source>
        <translation>前半段快，两端加速度为零。</translation>
    </message>
    <message>
        <source>Ramp fraction r</source>
        <translation>斜坡比例 r</translation>
    </message>
    <message>
        <source>Jerk share q</source>
        <translation>跃度比例 q</translation>
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
</context>
<context>
    <name>campanel::machine::DownloadDesk</name>
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
        <source>Knife radius, knives, pulses and gear change only at standstill. Stop the machine first.</source>
        <translation>刀半径、刀数、脉冲数和传动比只能在静止时更改。请先停机。</translation>
    </message>
    <message>
        <source>The controller runs exactly this.</source>
        <translation>控制器运行的正是此程序。</translation>
    </message>
    <message>
        <source>Takes effect at the end of the cycle.</source>
        <translation>在本周期结束时生效。</translation>
    </message>
    <message>
        <source>Takes effect at once.</source>
        <translation>立即生效。</translation>
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
</context>
<context>
    <name>campanel::machine::EditorField</name>
    <message>
        <source>Enter a number.</source>
        <translation>请输入数字。</translation>
    </message>
    <message>
        <source>The smallest allowed value is %1.</source>
        <translation>最小允许值为 %1。</translation>
    </message>
    <message>
        <source>The smallest allowed value is %1 %2.</source>
        <translation>最小允许值为 %1 %2。</translation>
    </message>
    <message>
        <source>The largest allowed value is %1.</source>
        <translation>最大允许值为 %1。</translation>
    </message>
    <message>
        <source>The largest allowed value is %1 %2.</source>
        <translation>最大允许值为 %1 %2。</translation>
    </message>
</context>
<context>
    <name>campanel::machine::Machine</name>
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
        <source>The controller has no program. Download a recipe first.</source>
        <translation>控制器没有程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The machine is running.</source>
        <translation>机器正在运行。</translation>
    </message>
    <message>
        <source>The machine is stopping.</source>
        <translation>机器正在停止。</translation>
    </message>
    <message>
        <source>The machine is moving.</source>
        <translation>机器正在运动。</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>控制器处于故障状态。请先复位故障。</translation>
    </message>
    <message>
        <source>The state of the controller is not known.</source>
        <translation>控制器状态未知。</translation>
    </message>
</context>
<context>
    <name>campanel::machine::Settings</name>
    <message>
        <source>Not permitted: add the user to the group &quot;%1&quot;.</source>
        <translation>无权限：请将用户加入“%1”组。</translation>
    </message>
</context>
<context>
    <name>campanel::machine::TableModel</name>
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
</context>
</TS>
