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
        <source>view everything, stop the machine</source>
        <translation>查看全部、停机</translation>
    </message>
    <message>
        <source>start, bag length, rate, recipes, alarms</source>
        <translation>启动、袋长、速率、配方、报警</translation>
    </message>
    <message>
        <source>plus cam, machine, packing, connection</source>
        <translation>另加凸轮、机器、包装、通信</translation>
    </message>
    <message>
        <source>plus users and single registers</source>
        <translation>另加用户和单个寄存器</translation>
    </message>
    <message>
        <source>Log in to operate the machine. Stop needs no login.</source>
        <translation>操作机器须先登录。停止无需登录。</translation>
    </message>
    <message>
        <source>This requires the level Technician or Service. Users with this level:</source>
        <translation>需要“技术员”或“维护”级权限。具有权限的用户：</translation>
    </message>
    <message>
        <source>This requires the level Service. Users with this level:</source>
        <translation>需要“维护”级权限。具有权限的用户：</translation>
    </message>
    <message>
        <source>A PIN has %1 to %2 digits.</source>
        <translation>PIN 为 %1 至 %2 位数字。</translation>
    </message>
    <message>
        <source>A PIN of equal digits is easy to guess. Choose another PIN.</source>
        <translation>各位相同的 PIN 容易被猜到。请换一个 PIN。</translation>
    </message>
    <message>
        <source>Sequences such as 1234 are easy to guess. Choose another PIN.</source>
        <translation>像 1234 这样的连续数字容易被猜到。请换一个 PIN。</translation>
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
        <translation>PIN 错误。请在 %1 后重试。</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again.</source>
        <translation>PIN 错误。请重试。</translation>
    </message>
    <message>
        <source>Locked after wrong PINs. Try again in %1.</source>
        <translation>PIN 输错后锁定。请在 %1 后重试。</translation>
    </message>
    <message>
        <source>%1 Until then PINs cannot be checked: only operators can work.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1在此之前无法核对 PIN，只能以操作员权限操作。</translation>
    </message>
    <message>
        <source>A PIN of the level Service has %1 to %2 digits.</source>
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
        <source>Following error too large</source>
        <translation>跟随误差过大</translation>
    </message>
    <message>
        <source>The axis cannot follow its setpoint.</source>
        <translation>轴跟不上设定值。</translation>
    </message>
    <message>
        <source>Check for a jam, reset the fault, then start the reference run.</source>
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
        <source>No index mark was found in the reference run.</source>
        <translation>回零时没有找到零位标记。</translation>
    </message>
    <message>
        <source>Check drive and index sensor, then reset the fault.</source>
        <translation>请检查驱动器和零位传感器，然后复位故障。</translation>
    </message>
    <message>
        <source>Max. force reached</source>
        <translation>达到最大力</translation>
    </message>
    <message>
        <source>The press reached the maximum force, stopped and returned.</source>
        <translation>压装力达到最大值，压机已停止并返回。</translation>
    </message>
    <message>
        <source>Check for a jam or a wrong workpiece, then reset the fault.</source>
        <translation>请检查是否卡阻或工件有误，然后复位故障。</translation>
    </message>
    <message>
        <source>Contact too early</source>
        <translation>过早接触工件</translation>
    </message>
    <message>
        <source>The press touched an object during the approach.</source>
        <translation>压头在快进途中碰到物体。</translation>
    </message>
    <message>
        <source>Check the workpiece and the approach position, then reset the fault.</source>
        <translation>请检查工件和快进位置，然后复位故障。</translation>
    </message>
    <message>
        <source>No workpiece</source>
        <translation>没有工件</translation>
    </message>
    <message>
        <source>The press did not detect a workpiece.</source>
        <translation>压机未探测到工件。</translation>
    </message>
    <message>
        <source>Insert a workpiece or check the probe position, then reset the fault.</source>
        <translation>请放入工件或检查探测位置，然后复位故障。</translation>
    </message>
    <message>
        <source>Master too fast</source>
        <translation>主轴过快</translation>
    </message>
    <message>
        <source>The axis cannot follow the master: the pulse frequency is too high.</source>
        <translation>从轴跟不上主轴：脉冲频率过高。</translation>
    </message>
    <message>
        <source>Lower the master speed, then reset the fault.</source>
        <translation>请降低主轴速度，然后复位故障。</translation>
    </message>
    <message>
        <source>Drive alarm</source>
        <translation>驱动器报警</translation>
    </message>
    <message>
        <source>The drive of the axis reports an alarm.</source>
        <translation>轴的驱动器发出报警。</translation>
    </message>
    <message>
        <source>Read the code on the drive and remove its cause, then reset the fault.</source>
        <translation>请查看驱动器上的代码并排除原因，然后复位故障。</translation>
    </message>
    <message>
        <source>Unknown fault</source>
        <translation>未知故障</translation>
    </message>
    <message>
        <source>The controller reports a fault that this panel does not know.</source>
        <translation>控制器报告了本面板无法识别的故障。</translation>
    </message>
    <message>
        <source>Update the panel. Until then check the machine before you reset the fault.</source>
        <translation>请更新面板。更新前，复位故障之前请先检查机器。</translation>
    </message>
    <message>
        <source>No panel heartbeat</source>
        <translation>面板心跳中断</translation>
    </message>
    <message>
        <source>The controller received no heartbeat from the panel for some time.</source>
        <translation>控制器有一段时间没有收到面板的心跳。</translation>
    </message>
    <message>
        <source>Check the cable.</source>
        <translation>请检查电缆。</translation>
    </message>
    <message>
        <source>Not referenced</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>The controller does not know the position of the axis.</source>
        <translation>控制器不知道轴的位置。</translation>
    </message>
    <message>
        <source>No action required: Start begins with the reference run.</source>
        <translation>无需处理：启动时会先回零。</translation>
    </message>
    <message>
        <source>Saved copy damaged</source>
        <translation>保存的副本损坏</translation>
    </message>
    <message>
        <source>One of the two saved copies in the controller is damaged.</source>
        <translation>控制器中两份保存副本有一份损坏。</translation>
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
        <source>The controller has had no time of day since power-on.</source>
        <translation>控制器上电后尚未获得当前时间。</translation>
    </message>
    <message>
        <source>No action required: the panel sets the clock when it connects.</source>
        <translation>无需处理：面板连接时会自动设定时钟。</translation>
    </message>
    <message>
        <source>Emergency stop pressed</source>
        <translation>急停已按下</translation>
    </message>
    <message>
        <source>The emergency stop of the machine is pressed.</source>
        <translation>机器的急停按钮已按下。</translation>
    </message>
    <message>
        <source>Make sure that the machine is safe, then release the emergency stop.</source>
        <translation>请确认机器安全，然后释放急停按钮。</translation>
    </message>
    <message>
        <source>Unknown warning</source>
        <translation>未知警告</translation>
    </message>
    <message>
        <source>The controller reports a warning that this panel does not know.</source>
        <translation>控制器报告了本面板无法识别的警告。</translation>
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
        <source>The controller lost the marks on the film and stopped the run.</source>
        <translation>薄膜上的色标丢失，运行已停止。</translation>
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
        <source>The mark distance on the film differs from the bag length, so the run was stopped.</source>
        <translation>薄膜上的色标间距与袋长不符，运行已停止。</translation>
    </message>
    <message>
        <source>Correction limit reached</source>
        <translation>修正达到限值</translation>
    </message>
    <message>
        <source>The correction limits were too small to follow the marks, so the run was stopped.</source>
        <translation>修正达到限值，切断仍跟不上色标，运行已停止。</translation>
    </message>
    <message>
        <source>Check the film for tension and slip, then start again.</source>
        <translation>请检查薄膜张力以及是否打滑，然后重新启动。</translation>
    </message>
    <message>
        <source>Product too long</source>
        <translation>产品过长</translation>
    </message>
    <message>
        <source>A product is longer than the bag, so the run was stopped.</source>
        <translation>有产品长于袋长，运行已停止。</translation>
    </message>
    <message>
        <source>Remove the product or set a longer bag, then start again.</source>
        <translation>请取出该产品或设定更长的袋长，然后重新启动。</translation>
    </message>
    <message>
        <source>Too many skipped cuts</source>
        <translation>略过的切断过多</translation>
    </message>
    <message>
        <source>Products blocked the knife several times in a row, so the run was stopped.</source>
        <translation>产品连续多次挡住切刀，运行已停止。</translation>
    </message>
    <message>
        <source>Align the products, then start again.</source>
        <translation>请理顺产品，然后重新启动。</translation>
    </message>
    <message>
        <source>Port missing</source>
        <translation>端口不存在</translation>
    </message>
    <message>
        <source>The port to the controller does not exist.</source>
        <translation>连接控制器的端口不存在。</translation>
    </message>
    <message>
        <source>Plug the adapter in, or choose another port in the settings.</source>
        <translation>请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>No response</source>
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
        <source>The connection to the controller was interrupted.</source>
        <translation>与控制器的连接已中断。</translation>
    </message>
    <message>
        <source>Check the cable and the controller&apos;s power; the panel reconnects automatically.</source>
        <translation>请检查电缆和控制器电源；面板会自动重新连接。</translation>
    </message>
    <message>
        <source>Wrong device</source>
        <translation>设备不符</translation>
    </message>
    <message>
        <source>The device on the port is not a controller that this panel knows.</source>
        <translation>端口上的设备不是本面板能识别的控制器。</translation>
    </message>
    <message>
        <source>Choose another port or unit number, or update the older device.</source>
        <translation>请选择其他端口或站号，或升级版本较旧的一方。</translation>
    </message>
    <message>
        <source>Port not usable</source>
        <translation>端口不可用</translation>
    </message>
    <message>
        <source>The port to the controller exists but cannot be used.</source>
        <translation>连接控制器的端口存在，但无法使用。</translation>
    </message>
    <message>
        <source>Close the program that uses the port, or choose another port or other settings.</source>
        <translation>请关闭占用端口的程序，或选择其他端口或设置。</translation>
    </message>
    <message>
        <source>Simulated controller missing</source>
        <translation>仿真控制器缺失</translation>
    </message>
    <message>
        <source>The simulated controller was not found or has stopped.</source>
        <translation>没有找到仿真控制器，或仿真控制器已退出。</translation>
    </message>
    <message>
        <source>Install the simulated controller, or choose a serial port in the settings.</source>
        <translation>请安装仿真控制器，或在设置中选择串口。</translation>
    </message>
    <message>
        <source>Database replaced by its copy</source>
        <translation>数据库已换用副本</translation>
    </message>
    <message>
        <source>Check that the newest recipes are there. If this happens again, replace the disk.</source>
        <translation>请检查最新的配方是否还在。如再次出现，请更换磁盘。</translation>
    </message>
    <message>
        <source>Database lost</source>
        <translation>数据库丢失</translation>
    </message>
    <message>
        <source>Restore a backup if there is one. If this happens again, replace the disk.</source>
        <translation>如有备份请恢复。如再次出现，请更换磁盘。</translation>
    </message>
    <message>
        <source>Database not opened</source>
        <translation>数据库无法打开</translation>
    </message>
    <message>
        <source>The panel cannot open its database: new data are lost at a restart.</source>
        <translation>面板无法打开数据库：新数据在重启后丢失。</translation>
    </message>
    <message>
        <source>Read the detail, remove the cause and restart the panel.</source>
        <translation>请查看详情，排除原因后重新启动面板。</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>The panel&apos;s disk is full: new data are not saved.</source>
        <translation>面板磁盘已满：新数据无法保存。</translation>
    </message>
    <message>
        <source>Free some disk space. Data saved before are not lost.</source>
        <translation>请腾出磁盘空间。之前保存的数据没有丢失。</translation>
    </message>
    <message>
        <source>Disk write-protected</source>
        <translation>磁盘写保护</translation>
    </message>
    <message>
        <source>The panel cannot write to its disk: new data are not saved.</source>
        <translation>面板无法写入磁盘：新数据无法保存。</translation>
    </message>
    <message>
        <source>Remove the write protection. If the disk protects itself, replace the disk.</source>
        <translation>请解除写保护。如磁盘自行写保护，请更换。</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未能保存</translation>
    </message>
    <message>
        <source>Some data could not be saved in the panel&apos;s database.</source>
        <translation>有数据未能保存到面板的数据库。</translation>
    </message>
    <message>
        <source>Read the detail and try again. If this happens again, restart the panel.</source>
        <translation>请查看详情并重试。如再次出现，请重新启动面板。</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>配方文件</translation>
    </message>
    <message>
        <source>The last recipe could not be read or saved.</source>
        <translation>最近的配方无法读取或保存。</translation>
    </message>
    <message>
        <source>Read the detail; check the recipe before you download it.</source>
        <translation>请查看详情；下载前请核对配方。</translation>
    </message>
    <message>
        <source>Settings file damaged</source>
        <translation>设置文件损坏</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing.</source>
        <translation>设置文件损坏或丢失。</translation>
    </message>
    <message>
        <source>Read the detail; check the settings, the connection first.</source>
        <translation>请查看详情；检查设置，先检查连接。</translation>
    </message>
    <message>
        <source>Touchscreen missing</source>
        <translation>触摸屏丢失</translation>
    </message>
    <message>
        <source>A touchscreen of this panel was unplugged or has failed.</source>
        <translation>本面板的触摸屏被拔出或发生故障。</translation>
    </message>
    <message>
        <source>Check the cable of the touchscreen. Stop the machine with its own switch.</source>
        <translation>请检查触摸屏的电缆。请用机器自身的开关停机。</translation>
    </message>
    <message>
        <source>Settings not saved</source>
        <translation>设置未保存</translation>
    </message>
    <message>
        <source>The settings cannot be saved: they are lost when the panel is switched off.</source>
        <translation>设置无法保存：面板关机后丢失。</translation>
    </message>
    <message>
        <source>Check for a full or write-protected disk.</source>
        <translation>请检查磁盘是否已满或写保护。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged or missing. The last good copy is used.</source>
        <translation>面板的数据库损坏或丢失，现使用最近的完好副本。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged or missing and there was no copy. A new, empty database was created.</source>
        <translation>面板的数据库损坏或丢失，且没有副本。已新建空数据库。</translation>
    </message>
    <message>
        <source>Users and PINs lost</source>
        <translation>用户和 PIN 丢失</translation>
    </message>
    <message>
        <source>The users were lost with the panel&apos;s database: only operators can work.</source>
        <translation>用户随面板的数据库一起丢失：只能以操作员权限操作。</translation>
    </message>
    <message>
        <source>Delete the file named in the detail. Then restore a backup.</source>
        <translation>请删除详情中写明的文件，然后恢复备份。</translation>
    </message>
    <message>
        <source>Mark sensor has drifted</source>
        <translation>色标传感器已漂移</translation>
    </message>
    <message>
        <source>The mark sensor&apos;s dead time is not the one entered: cuts move on the print when the speed changes.</source>
        <translation>色标传感器的滞后时间与输入值不符：变速时切断位置会在印刷图案上移动。</translation>
    </message>
    <message>
        <source>Clean and check the sensor. If the alarm stays, take over the learned dead time under Maintenance, Packing.</source>
        <translation>请清洁并检查传感器。如果报警仍在，请在“维护”的“包装”中采用学到的滞后时间。</translation>
    </message>
    <message>
        <source>Products joined</source>
        <translation>产品粘连</translation>
    </message>
    <message>
        <source>Take the products off the infeed, then start again.</source>
        <translation>请从进料处取下产品，然后重新启动。</translation>
    </message>
    <message>
        <source>Jaws closed</source>
        <translation>封切口闭合</translation>
    </message>
    <message>
        <source>Open them by hand. The bags on both sides are scrap.</source>
        <translation>请用手打开。两侧的袋子均为废品。</translation>
    </message>
    <message>
        <source>Two products hang together on the infeed, so the run was stopped.</source>
        <translation>进料处有两个产品粘连，运行已停止。</translation>
    </message>
    <message>
        <source>The jaws have been closed on standing film for too long.</source>
        <translation>封切口在静止的薄膜上闭合时间过长。</translation>
    </message>
    <message>
        <source>Load the right film, or measure its marks and tell them from other prints under Maintenance.</source>
        <translation>请装入正确的薄膜，或在“维护”中测量色标并将其与其他印刷区分。</translation>
    </message>
    <message>
        <source>Jam at the jaws</source>
        <translation>封切口卡料</translation>
    </message>
    <message>
        <source>Take out what lies between the jaws, then reset the fault and start. The machine goes on from there and rejects two bags.</source>
        <translation>请取出封切口之间的物品，然后复位故障并启动。机器从该处继续运行，并剔除两个袋子。</translation>
    </message>
    <message>
        <source>Something is under the closing jaws.</source>
        <translation>闭合的封切口下有异物。</translation>
    </message>
    <message>
        <source>Line too fast</source>
        <translation>生产线过快</translation>
    </message>
    <message>
        <source>Slow the line down or download a faster program, then start again.</source>
        <translation>降低生产线速度或下载更快的程序，然后重新启动。</translation>
    </message>
    <message>
        <source>The line became faster than the program allows, so the run was stopped.</source>
        <translation>生产线速度超过程序允许值，运行已停止。</translation>
    </message>
    <message>
        <source>Encoder signal disturbed</source>
        <translation>编码器信号受干扰</translation>
    </message>
    <message>
        <source>Check the cable and the shield of the encoder, then reset the fault.</source>
        <translation>请检查编码器的电缆和屏蔽，然后复位故障。</translation>
    </message>
    <message>
        <source>Encoder counts lost</source>
        <translation>编码器丢失计数</translation>
    </message>
    <message>
        <source>Check the encoder, its coupling and its cable, then reset the fault.</source>
        <translation>请检查编码器、联轴器和电缆，然后复位故障。</translation>
    </message>
    <message>
        <source>Wheel slips on the film</source>
        <translation>测量轮在薄膜上打滑</translation>
    </message>
    <message>
        <source>Clean the wheel and press it on the film, then reset the fault.</source>
        <translation>请清洁测量轮并压紧在薄膜上，然后复位故障。</translation>
    </message>
    <message>
        <source>Impossible encoder speed</source>
        <translation>编码器速度不合理</translation>
    </message>
    <message>
        <source>Check the encoder and its counts per revolution, then reset the fault.</source>
        <translation>请检查编码器及其每转计数，然后复位故障。</translation>
    </message>
    <message>
        <source>The signal of the encoder that leads the line is disturbed.</source>
        <translation>主轴编码器的信号受干扰。</translation>
    </message>
    <message>
        <source>The encoder that leads the line has lost or gained counts.</source>
        <translation>主轴编码器的计数有丢失或多出。</translation>
    </message>
    <message>
        <source>The wheel of the encoder slips on the film.</source>
        <translation>编码器的测量轮在薄膜上打滑。</translation>
    </message>
    <message>
        <source>The encoder that leads the line reports a speed that no machine has.</source>
        <translation>主轴编码器报告的速度不可能出现在任何机器上。</translation>
    </message>
    <message>
        <source>Master runs backward</source>
        <translation>主轴反转</translation>
    </message>
    <message>
        <source>The master runs backward by more than a cycle.</source>
        <translation>主轴反转超过一个周期。</translation>
    </message>
    <message>
        <source>Door open</source>
        <translation>门已打开</translation>
    </message>
    <message>
        <source>Close the door, then start again.</source>
        <translation>请关门，然后重新启动。</translation>
    </message>
    <message>
        <source>Next machine not ready</source>
        <translation>下游设备未就绪</translation>
    </message>
    <message>
        <source>Clear the next machine, then start again.</source>
        <translation>请排除下游设备的原因，然后重新启动。</translation>
    </message>
    <message>
        <source>Date coder not ready</source>
        <translation>打码机未就绪</translation>
    </message>
    <message>
        <source>Clear the fault of the date coder or switch it on, then start again.</source>
        <translation>请排除打码机故障或将其接通，然后重新启动。</translation>
    </message>
    <message>
        <source>A door of the machine is open.</source>
        <translation>设备的门已打开。</translation>
    </message>
    <message>
        <source>The machine behind this one is not ready.</source>
        <translation>下游设备未就绪。</translation>
    </message>
    <message>
        <source>The date coder is not ready.</source>
        <translation>打码机未就绪。</translation>
    </message>
    <message>
        <source>Exchange wires A and B, or change the sign with Reversed counting under Settings, Machine, Master, then reset the fault.</source>
        <translation>请互换编码器的 A、B 相接线，或在“设置、机器、主轴”中更改反向计数，然后复位故障。</translation>
    </message>
    <message>
        <source>Data disk missing</source>
        <translation>数据磁盘缺失</translation>
    </message>
    <message>
        <source>The disk with the panel&apos;s data cannot be used. Recipes, users and records are missing, and new data are lost at a restart.</source>
        <translation>面板的数据磁盘无法使用。配方、用户和记录缺失，新数据会在重启时丢失。</translation>
    </message>
    <message>
        <source>Replace the disk and restore a backup.</source>
        <translation>请更换数据磁盘并恢复备份。</translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>Alarm of a newer panel version</source>
        <translation>较新面板版本的报警</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>未恢复，已确认</translation>
    </message>
    <message>
        <source>End unknown, acknowledged</source>
        <translation>结束时间未知，已确认</translation>
    </message>
    <message>
        <source>Cleared, acknowledged</source>
        <translation>已恢复，已确认</translation>
    </message>
    <message>
        <source>Active, not acknowledged</source>
        <translation>未恢复，未确认</translation>
    </message>
    <message>
        <source>End unknown, not acknowledged</source>
        <translation>结束时间未知，未确认</translation>
    </message>
    <message>
        <source>Cleared, not acknowledged</source>
        <translation>已恢复，未确认</translation>
    </message>
    <message>
        <source>Active, shelved</source>
        <translation>未恢复，已搁置</translation>
    </message>
    <message>
        <source>End unknown, shelved</source>
        <translation>结束时间未知，已搁置</translation>
    </message>
    <message>
        <source>Cleared, shelved</source>
        <translation>已恢复，已搁置</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>未恢复</translation>
    </message>
    <message>
        <source>End unknown</source>
        <translation>结束时间未知</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>到 %1</translation>
    </message>
    <message>
        <source>clock not set</source>
        <translation>时钟未设置</translation>
    </message>
</context>
<context>
    <name>AuditWords</name>
    <message>
        <source>All</source>
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
        <source>Row %1 was altered after it was written.</source>
        <translation>第 %1 行在写入后被改动。</translation>
    </message>
    <message>
        <source>Row %1 is missing: the audit trail was altered.</source>
        <translation>缺少第 %1 行：审计记录被改动。</translation>
    </message>
    <message>
        <source>Row %1 and all later rows are missing.</source>
        <translation>缺少第 %1 行及其后各行。</translation>
    </message>
    <message>
        <source>Checked: %1 rows, intact.</source>
        <translation>已检查：共 %1 行，完整无缺。</translation>
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
        <source>Audit trail</source>
        <translation>审计记录</translation>
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
        <source>Immediate stop</source>
        <translation>立即停止</translation>
    </message>
    <message>
        <source>Reference run</source>
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
        <source>Program value</source>
        <translation>程序参数值</translation>
    </message>
    <message>
        <source>Parameter written</source>
        <translation>写入参数</translation>
    </message>
    <message>
        <source>Mark sensor measured</source>
        <translation>测量色标传感器</translation>
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
        <source>Automatic logout</source>
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
        <source>Level changed</source>
        <translation>更改级别</translation>
    </message>
    <message>
        <source>User removed</source>
        <translation>删除用户</translation>
    </message>
    <message>
        <source>Rows lost</source>
        <translation>记录丢失</translation>
    </message>
    <message>
        <source>Oldest rows deleted</source>
        <translation>删除最旧记录</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>network address</source>
        <translation>网络地址</translation>
    </message>
    <message>
        <source>simulated faults</source>
        <translation>故障模拟</translation>
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
        <source>not received by the controller</source>
        <translation>控制器未收到</translation>
    </message>
    <message>
        <source>not known: no confirmation</source>
        <translation>未知：没有得到确认</translation>
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
        <source>locked after wrong PINs</source>
        <translation>PIN 输错后锁定</translation>
    </message>
    <message>
        <source>written, but the cuts still deviate</source>
        <translation>已写入，但切断仍有偏差</translation>
    </message>
    <message>
        <source>Backup and restore</source>
        <translation>备份与恢复</translation>
    </message>
    <message>
        <source>Backup created</source>
        <translation>生成备份</translation>
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
        <source>Reference run ended</source>
        <translation>回零结束</translation>
    </message>
    <message>
        <source>Jog forward</source>
        <translation>正向点动</translation>
    </message>
    <message>
        <source>Jog reverse</source>
        <translation>反向点动</translation>
    </message>
    <message>
        <source>Jog ended</source>
        <translation>点动结束</translation>
    </message>
    <message>
        <source>key released</source>
        <translation>按键已松开</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
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
        <source>Recipe restored</source>
        <translation>配方已恢复</translation>
    </message>
    <message>
        <source>Newest row unknown</source>
        <translation>最新一行未知</translation>
    </message>
    <message>
        <source>Intact up to row %1. The file with the newest row is missing: later rows may be lost.</source>
        <translation>到第 %1 行为止完整无缺。记录最新一行的文件丢失：其后的行可能丢失。</translation>
    </message>
    <message>
        <source>Checked: %1 rows, intact; rows may have been lost earlier, see the trail.</source>
        <translation>已检查：共 %1 行，完整无缺；此前可能丢失过记录，见记录。</translation>
    </message>
    <message>
        <source>Panel database</source>
        <translation>面板数据库</translation>
    </message>
    <message>
        <source>Replaced by its copy</source>
        <translation>已由副本替换</translation>
    </message>
    <message>
        <source>Lost, new and empty</source>
        <translation>已丢失，已新建空库</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Command from the network</source>
        <translation>来自网络的命令</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>Reason of a stop changed</source>
        <translation>停机原因已更改</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>time zone</source>
        <translation>时区</translation>
    </message>
    <message>
        <source>time server</source>
        <translation>时间服务器</translation>
    </message>
    <message>
        <source>Film reels</source>
        <translation>膜卷</translation>
    </message>
    <message>
        <source>Film reel scanned</source>
        <translation>已扫描膜卷</translation>
    </message>
    <message>
        <source>Wrong film reel allowed</source>
        <translation>允许使用错误膜卷</translation>
    </message>
    <message>
        <source>Updates</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Update requested</source>
        <translation>请求更新</translation>
    </message>
    <message>
        <source>Earlier version requested</source>
        <translation>请求恢复旧版本</translation>
    </message>
    <message>
        <source>Installation ended</source>
        <translation>安装结束</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>已请求</translation>
    </message>
    <message>
        <source>calibration of the touchscreen</source>
        <translation>触摸屏校准</translation>
    </message>
    <message>
        <source>Recipe file lost or damaged</source>
        <translation>配方文件丢失或损坏</translation>
    </message>
    <message>
        <source>Machine data lost or damaged</source>
        <translation>机器数据丢失或损坏</translation>
    </message>
    <message>
        <source>User renamed</source>
        <translation>用户已改名</translation>
    </message>
    <message>
        <source>Another version runs</source>
        <translation>版本已变更</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>gateway</source>
        <translation>网关</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>报警已确认</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>报警已搁置</translation>
    </message>
    <message>
        <source>Alarm unshelved</source>
        <translation>报警已取消搁置</translation>
    </message>
    <message>
        <source>Files written</source>
        <translation>文件已写出</translation>
    </message>
    <message>
        <source>Connection diagnosed</source>
        <translation>连接已诊断</translation>
    </message>
    <message>
        <source>Controller searched for</source>
        <translation>已搜索控制器</translation>
    </message>
    <message>
        <source>Statistics reset</source>
        <translation>统计已清零</translation>
    </message>
    <message>
        <source>Output tried</source>
        <translation>输出已测试</translation>
    </message>
    <message>
        <source>Output try ended</source>
        <translation>输出测试已结束</translation>
    </message>
    <message>
        <source>Order started or changed</source>
        <translation>订单已开始或更改</translation>
    </message>
    <message>
        <source>Order ended</source>
        <translation>订单已结束</translation>
    </message>
    <message>
        <source>Speed changed by hand</source>
        <translation>手动更改速度</translation>
    </message>
    <message>
        <source>Trimmed by hand</source>
        <translation>手动微调</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>Order added</source>
        <translation>订单已添加</translation>
    </message>
    <message>
        <source>Order removed</source>
        <translation>订单已删除</translation>
    </message>
    <message>
        <source>First bag checked</source>
        <translation>首袋已检查</translation>
    </message>
    <message>
        <source>One bag by hand</source>
        <translation>手动单袋</translation>
    </message>
    <message>
        <source>Single cut by hand</source>
        <translation>手动单次切断</translation>
    </message>
    <message>
        <source>Next bag taken</source>
        <translation>取走下一袋</translation>
    </message>
    <message>
        <source>File of the machine builder</source>
        <translation>设备制造商的文件</translation>
    </message>
    <message>
        <source>Value outside its approved window</source>
        <translation>数值超出批准范围</translation>
    </message>
    <message>
        <source>system</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>Axis measured</source>
        <translation>测量轴</translation>
    </message>
    <message>
        <source>Measurement of an axis ended</source>
        <translation>轴测量结束</translation>
    </message>
    <message>
        <source>Measured value of an axis taken</source>
        <translation>已采用轴的测量值</translation>
    </message>
</context>
<context>
    <name>Availability</name>
    <message>
        <source>Program type and machine data can only be changed at standstill. Stop the machine first.</source>
        <translation>程序类型和机器数据只能在静止时更改。请先停机。</translation>
    </message>
    <message>
        <source>Start the machine: this step continues while the machine runs.</source>
        <translation>请启动机器：此步骤在机器运行时继续。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it first: diagnosis and search interrupt the connection.</source>
        <translation>机器正在运动。请先停机：诊断和搜索会中断连接。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before changing the screen.</source>
        <translation>机器正在运动。更改屏幕设置前请先停机。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before calibrating the touchscreen.</source>
        <translation>机器正在运动。校准触摸屏前请先停机。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before the update; the panel will restart.</source>
        <translation>机器正在运动。更新前请先停机；面板将重启。</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before restoring; the panel will restart.</source>
        <translation>机器正在运动。请先停机：恢复后面板将重新启动。</translation>
    </message>
    <message>
        <source>The controller&apos;s state is unknown.</source>
        <translation>控制器的状态未知。</translation>
    </message>
    <message>
        <source>The machine is running. Stop it first.</source>
        <translation>机器正在运行。请先停机。</translation>
    </message>
    <message>
        <source>The machine is stopping. Wait for standstill.</source>
        <translation>机器正在停止。请等它停稳。</translation>
    </message>
    <message>
        <source>The reference run is active. Wait for standstill.</source>
        <translation>轴正在回零。请等它停稳。</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>控制器处于故障状态。请先复位故障。</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>没有连接到控制器。</translation>
    </message>
    <message>
        <source>The axis is jogging. Wait for standstill.</source>
        <translation>轴正在点动。请等待停止。</translation>
    </message>
</context>
<context>
    <name>BackupErrorText</name>
    <message>
        <source>The file %1 cannot be read: %2. Nothing was changed.</source>
        <translation>无法读取文件 %1：%2。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 is not a backup of CamPanel. Nothing was changed.</source>
        <translation>%1 不是 CamPanel 的备份。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 was made by the newer CamPanel %2. Install that version first. Nothing was changed.</source>
        <translation>%1 由更新的 CamPanel %2 生成。请先安装该版本；没有任何更改。</translation>
    </message>
    <message>
        <source>%1 is damaged (%2). Use another backup. Nothing was changed.</source>
        <translation>%1 已损坏（%2）。请使用其他备份；没有任何更改。</translation>
    </message>
    <message>
        <source>The backup cannot be unpacked: %1. Free space on this panel. Nothing was changed.</source>
        <translation>无法解压备份：%1。请在本面板上腾出空间；没有任何更改。</translation>
    </message>
    <message>
        <source>%1 MB are required and %2 MB are free</source>
        <translation>需要 %1 MB，剩余 %2 MB</translation>
    </message>
    <message>
        <source>%1 is protected by a password. Unpack it on a computer and pack it as a zip file without a password. Nothing was changed.</source>
        <translation>%1 有密码保护。请在电脑上解压，再打包为无密码的 zip 文件。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 was packed in a way that this panel cannot read. Unpack it on a computer and pack it as a usual zip file. Nothing was changed.</source>
        <translation>%1 的压缩方式本面板无法读取。请在电脑上解压，再打包为普通 zip 文件。没有任何更改。</translation>
    </message>
    <message>
        <source>%1 was altered by another program: %2 is not of CamPanel. Use another backup. Nothing was changed.</source>
        <translation>%1 被其他程序改动过：%2 不属于 CamPanel。请使用其他备份；没有任何更改。</translation>
    </message>
    <message>
        <source>%1 has no users, but this panel has PINs. Use a backup that was made after the first PIN. Nothing was changed.</source>
        <translation>%1 中没有用户，而本面板已设置 PIN。请使用设置首个 PIN 之后制作的备份；没有任何更改。</translation>
    </message>
    <message>
        <source>Nobody in %1 can log in as Service: the panel could not be set up any more. Use another backup. Nothing was changed.</source>
        <translation>%1 中没有人能以维护级别登录：面板将无法再设置。请使用其他备份；没有任何更改。</translation>
    </message>
</context>
<context>
    <name>CamSentences</name>
    <message>
        <source>The axis advances by %1 per cycle.</source>
        <translation>轴每周期净进给 %1。</translation>
    </message>
    <message>
        <source>The axis advances by %1 in every cycle, and no travel limit stops it.</source>
        <translation>轴每周期净进给 %1，且没有行程限位使其停止。</translation>
    </message>
    <message>
        <source>The ends of the cam differ by %1; the table closes the cam.</source>
        <translation>凸轮两端相差 %1，程序表会将其闭合。</translation>
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
        <source>Identifying the controller on %1 …</source>
        <translation>正在识别 %1 上的控制器…</translation>
    </message>
    <message>
        <source>Searching for port %1 …</source>
        <translation>正在查找端口 %1…</translation>
    </message>
    <message>
        <source>The simulated controller was not found at %1. Install it, or choose a serial port in the settings.</source>
        <translation>在 %1 没有找到仿真控制器。请安装仿真控制器，或在设置中选择串口。</translation>
    </message>
    <message>
        <source>The simulated controller has stopped and is restarting.</source>
        <translation>仿真控制器已退出，正在重新启动。</translation>
    </message>
    <message>
        <source>The simulated controller has stopped and is restarting. Its output: %1</source>
        <translation>仿真控制器已退出，正在重新启动。它的输出：%1</translation>
    </message>
    <message>
        <source>The simulated controller is starting …</source>
        <translation>仿真控制器正在启动…</translation>
    </message>
    <message>
        <source>Port %1 does not exist. Plug the adapter in, or choose another port in the settings.</source>
        <translation>端口 %1 不存在。请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>Another program is using port %1. Close that program, or choose another port.</source>
        <translation>端口 %1 正被其他程序占用。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>This user has no right to use port %1. Add the user to the group &quot;%2&quot; and log in again.</source>
        <translation>当前用户无权使用端口 %1。请将用户加入“%2”组并重新登录。</translation>
    </message>
    <message>
        <source>This user has no right to use port %1. Ask the administrator for this right.</source>
        <translation>当前用户无权使用端口 %1。请向管理员申请权限。</translation>
    </message>
    <message>
        <source>%1 is not a serial port. Choose another port in the settings.</source>
        <translation>%1 不是串口。请在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>Port %1 cannot be set up: %2. Choose other settings.</source>
        <translation>端口 %1 无法设置：%2。请选择其他设置。</translation>
    </message>
    <message>
        <source>Port %1 was removed. Plug the adapter in again.</source>
        <translation>端口 %1 已移除。请重新插上适配器。</translation>
    </message>
    <message>
        <source>No response on %1. Check cable, power, baud rate, parity and unit number.</source>
        <translation>%1 上没有应答。请检查电缆、电源、波特率、校验和站号。</translation>
    </message>
    <message>
        <source>Invalid data on %1. Check baud rate, parity and stop bits.</source>
        <translation>%1 上收到的数据无效。请检查波特率、校验和停止位。</translation>
    </message>
    <message>
        <source>Stray bytes behind a response on %1. Check the bias resistors, and the switching between sending and receiving.</source>
        <translation>%1 上的应答之后有多余字节。请检查偏置电阻以及收发切换。</translation>
    </message>
    <message>
        <source>Responses on %1 belong to other requests. Check for another master on the line.</source>
        <translation>%1 上的应答不属于本面板的请求。请检查线路上是否有其他主站。</translation>
    </message>
    <message>
        <source>The device on %1 reports a failure (Modbus exception %2). Restart the device.</source>
        <translation>%1 上的设备报告故障（Modbus 异常 %2）。请重新启动设备。</translation>
    </message>
    <message>
        <source>The device on %1 is busy (Modbus exception %2). Wait, or restart the device.</source>
        <translation>%1 上的设备忙（Modbus 异常 %2）。请等待，或重新启动设备。</translation>
    </message>
    <message>
        <source>The gateway on %1 gets no response from the controller (Modbus exception %2). Check the unit number, and the line behind the gateway.</source>
        <translation>%1 上的网关收不到控制器的应答（Modbus 异常 %2）。请检查站号和网关之后的线路。</translation>
    </message>
    <message>
        <source>The device on %1 refuses the request (Modbus exception %2). Check that it is a CamPanel controller.</source>
        <translation>%1 上的设备拒绝请求（Modbus 异常 %2）。请检查是否为 CamPanel 控制器。</translation>
    </message>
    <message>
        <source>The device on %1 is not a CamPanel controller. Choose another port or unit number.</source>
        <translation>%1 上的设备不是 CamPanel 控制器。请选择其他端口或站号。</translation>
    </message>
    <message>
        <source>The controller on %1 has register map version %2, not %3. Update the older device.</source>
        <translation>%1 上控制器的寄存器表版本为 %2，而不是 %3。请升级较旧的一方。</translation>
    </message>
    <message>
        <source>The controller on %1 reports an impossible value: %2 is %3. Update its firmware.</source>
        <translation>%1 上的控制器报告了不可能的值：%2 为 %3。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller on %1 lacks required registers. Update its firmware.</source>
        <translation>%1 上的控制器缺少必需的寄存器。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller did not receive the command. Try again.</source>
        <translation>控制器没有收到命令。请重试。</translation>
    </message>
    <message>
        <source>It is unknown whether the controller received the command. Check the machine before you try again.</source>
        <translation>不确定控制器是否收到命令。请先检查机器，再重试。</translation>
    </message>
    <message>
        <source>The controller stored a different value. Try again.</source>
        <translation>控制器保存的值与写入值不同。请重试。</translation>
    </message>
    <message>
        <source>The controller does not allow this access to %1.</source>
        <translation>控制器不允许这样访问 %1。</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>%1 was refused. %2</source>
        <comment>%1: command, %2: whole sentence</comment>
        <translation>%1被拒绝。%2</translation>
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
        <source>%1 was sent, but no response was received. Check the machine before you try again.</source>
        <translation>%1已发送，但没有应答。请先检查机器，再重试。</translation>
    </message>
    <message>
        <source>Not downloaded: there is no connection to the controller.</source>
        <translation>未下载：没有连接到控制器。</translation>
    </message>
    <message>
        <source>Not downloaded: another download is in progress.</source>
        <translation>未下载：另一个下载正在进行。</translation>
    </message>
    <message>
        <source>The connection is lost. The download continues when it is restored.</source>
        <translation>连接中断。连接恢复后继续下载。</translation>
    </message>
    <message>
        <source>Sending the table …</source>
        <translation>正在发送数据表…</translation>
    </message>
    <message>
        <source>The controller is checking the table …</source>
        <translation>控制器正在检查数据表…</translation>
    </message>
    <message>
        <source>Checked. The program becomes active at the end of the cycle.</source>
        <translation>检查通过。程序在本周期结束时生效。</translation>
    </message>
    <message>
        <source>Canceled. The controller&apos;s program is unchanged.</source>
        <translation>已取消。控制器的程序没有改变。</translation>
    </message>
    <message>
        <source>Download failed; the controller&apos;s program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>下载失败，控制器的程序没有改变。%1</translation>
    </message>
    <message>
        <source>The table needs %1 registers, the controller has %2; its program is unchanged. Use fewer slices per ramp.</source>
        <translation>数据表需要 %1 个寄存器，控制器只有 %2 个，其程序没有改变。请减少斜坡分段数。</translation>
    </message>
    <message>
        <source>This controller cannot execute intervals; its program is unchanged. Choose cam points.</source>
        <translation>该控制器不能执行区间表，其程序没有改变。请选择凸轮点。</translation>
    </message>
    <message>
        <source>This controller cannot execute this kind of program; its program is unchanged. Update its firmware.</source>
        <translation>该控制器不能执行这类程序，其程序没有改变。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller refused the table; its program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>控制器拒绝了数据表，其程序没有改变。%1</translation>
    </message>
    <message>
        <source>The received data differ from the sent data; the controller&apos;s program is unchanged. Download again.</source>
        <translation>控制器收到的数据与发送的不同，其程序没有改变。请重新下载。</translation>
    </message>
    <message>
        <source>The controller did not apply the table; its program is unchanged. %1</source>
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
        <source>%1 was not changed. %2</source>
        <comment>%2: whole sentence</comment>
        <translation>%1未更改。%2</translation>
    </message>
    <message>
        <source>%1 was sent, but not confirmed. Check the machine before you try again.</source>
        <translation>%1已发送，但没有得到确认。请先检查机器，再重试。</translation>
    </message>
    <message>
        <source>The diagnostics are using the ports. The panel reconnects when they have finished.</source>
        <translation>通信诊断正在使用端口。诊断结束后恢复连接。</translation>
    </message>
    <message>
        <source>No connection since %1 to the simulated controller on %2. The panel reconnects automatically.</source>
        <translation>自 %1 起与 %2 上的仿真控制器没有连接。面板会自动重新连接。</translation>
    </message>
    <message>
        <source>No connection since %1: port %2 was removed. Plug the adapter in again; the panel finds it under any name and reconnects automatically.</source>
        <translation>自 %1 起没有连接：端口 %2 已移除。请重新插上适配器；端口改名也会自动重新连接。</translation>
    </message>
    <message>
        <source>No connection since %1: port %2 was removed. Plug the adapter into the same socket; the panel reconnects automatically.</source>
        <translation>自 %1 起无连接：端口 %2 已移除。请把适配器插回原来的插口，面板会自动重新连接。</translation>
    </message>
    <message>
        <source>No connection since %1. %2</source>
        <comment>time, %2: whole sentences</comment>
        <translation>自 %1 起无连接。%2</translation>
    </message>
    <message>
        <source>No connection since %1: no response on %2. Check the cable and the controller&apos;s power; the panel reconnects automatically.</source>
        <translation>自 %1 起没有连接：%2 上无应答。请检查电缆和控制器电源；面板会自动重新连接。</translation>
    </message>
    <message>
        <source>No controller is selected. Select one on the Settings page, under Connection.</source>
        <translation>未选择控制器。请在“设置”页的“通信”中选择。</translation>
    </message>
    <message>
        <source>The controller has this program.</source>
        <translation>控制器中已有此程序。</translation>
    </message>
</context>
<context>
    <name>ControllerSentences</name>
    <message>
        <source>The machine keeps following the line; the new recipe starts with the next cycle.</source>
        <translation>机器继续跟随生产线，新配方从下一周期开始。</translation>
    </message>
    <message>
        <source>Stops at the end of a cycle, then follows the line again (%1 at its present speed).</source>
        <translation>在周期结束处停止，然后重新跟随生产线（按其当前速度需 %1）。</translation>
    </message>
    <message>
        <source>The machine keeps running; the new recipe starts with the next cycle.</source>
        <translation>机器继续运行，新配方从下一周期开始。</translation>
    </message>
    <message>
        <source>Slows down to %1 % (bags: %2, %3), then %4 bags/min.</source>
        <translation>先降速至 %1 %（%2 袋，%3），然后 %4 袋/分。</translation>
    </message>
    <message>
        <source>Slows down to %1 % (cycles: %2, %3), then full speed.</source>
        <translation>先降速至 %1 %（%2 个周期，%3），然后全速。</translation>
    </message>
    <message>
        <source>%1 A product under the first cut adds %2 s.</source>
        <translation>%1首次切刀处若有产品，再加 %2 秒。</translation>
    </message>
    <message>
        <source>at least %1 s</source>
        <translation>至少 %1 秒</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>The controller reports reason %1, which this panel does not know. Update the panel.</source>
        <translation>控制器报告了本面板无法识别的原因（%1）。请更新面板。</translation>
    </message>
    <message>
        <source>No slowing down. Speeds up to %1 bags/min within %2.</source>
        <translation>不降速。%2内加速到 %1 袋/分。</translation>
    </message>
    <message>
        <source>No slowing down. Speeds up to full speed within %1.</source>
        <translation>不降速。%1内加速到全速。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>numbers of bags</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Scrap bags: %1; the first good bag within %2 s.</source>
        <translation>废袋：%1；%2 s 内出第一个合格袋。</translation>
    </message>
    <message>
        <source>%1 Skipped cuts: up to %2, a bag of up to %3.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 跳过的切断：最多 %2，最长的袋不超过 %3。</translation>
    </message>
    <message>
        <source>Changing to %1: scrap %2, up to %3 s</source>
        <translation>正在改为 %1：废袋 %2，最长 %3 s</translation>
    </message>
    <message>
        <source>Changing to %1: scrap %2, a bag of up to %4, up to %3 s</source>
        <translation>正在改为 %1：废袋 %2，最长的袋 %4，最多 %3 s</translation>
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
        <source>Pinned values</source>
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
        <source>Program type</source>
        <translation>程序类型</translation>
    </message>
    <message>
        <source>Displacement law</source>
        <translation>位移规律</translation>
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
        <translation>控制器站号不同</translation>
    </message>
    <message>
        <source>Controller with another version</source>
        <translation>控制器版本不同</translation>
    </message>
    <message>
        <source>Another device</source>
        <translation>其他设备</translation>
    </message>
    <message>
        <source>Invalid data</source>
        <translation>数据无效</translation>
    </message>
    <message>
        <source>No response</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Echo only</source>
        <translation>仅有回波</translation>
    </message>
    <message>
        <source>Error response</source>
        <translation>异常应答</translation>
    </message>
    <message>
        <source>Port does not exist</source>
        <translation>端口不存在</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>In use by another program</source>
        <translation>被其他程序占用</translation>
    </message>
    <message>
        <source>Not a serial port</source>
        <translation>不是串口</translation>
    </message>
    <message>
        <source>Settings not supported</source>
        <translation>不支持此设置</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>已拔出</translation>
    </message>
    <message>
        <source>A CamPanel controller with firmware %1 responds.</source>
        <translation>CamPanel 控制器应答，固件版本 %1。</translation>
    </message>
    <message>
        <source>A CamPanel controller responds at unit number %1, which differs from the setting. Use this connection, or set the unit number at the controller.</source>
        <translation>CamPanel 控制器在站号 %1 应答，与设置的站号不同。请使用此连接，或在控制器上修改站号。</translation>
    </message>
    <message>
        <source>A CamPanel controller responds with register map version %1, not %2. Update the older device.</source>
        <translation>CamPanel 控制器应答，其寄存器表版本为 %1，而不是 %2。请升级较旧的一方。</translation>
    </message>
    <message>
        <source>The responding device is not a CamPanel controller. Choose another port or unit number.</source>
        <translation>应答的设备不是 CamPanel 控制器。请选择其他端口或站号。</translation>
    </message>
    <message>
        <source>%1 bytes were received, but no valid response. Check baud rate, parity and stop bits, or search for the controller; then check shield and ground.</source>
        <translation>收到 %1 个字节，但没有有效应答。请检查波特率、校验和停止位，或搜索控制器；再检查屏蔽和接地。</translation>
    </message>
    <message>
        <source>No data was received. Check the controller&apos;s power and both ends of the cable; on RS-232 cross the transmit and receive wires, on RS-485 check A and B.</source>
        <translation>没有收到任何数据。请检查控制器电源和电缆两端；RS-232 的收发线须交叉，RS-485 请检查 A、B 是否接反。</translation>
    </message>
    <message>
        <source>The adapter echoes the requests, and no controller responds. Check the controller&apos;s power, both ends of the cable, and A and B.</source>
        <translation>适配器原样返回请求，没有控制器应答。请检查控制器电源、电缆两端，以及 A、B 是否接反。</translation>
    </message>
    <message>
        <source>%1 The line adds stray bytes to the responses (%2). Check the bias resistors, and the switching between sending and receiving.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 线路在应答中混入多余字节（%2 个）。请检查偏置电阻以及收发切换。</translation>
    </message>
    <message>
        <source>%1 The USB adapter delays data by %2 ms: set its latency timer to 1 ms.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1USB 适配器使数据延迟 %2 毫秒：请将其延迟定时器设为 1 毫秒。</translation>
    </message>
    <message>
        <source>This port does not exist. Plug the adapter in, or choose another port in the settings.</source>
        <translation>此端口不存在。请插入适配器，或在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>This user has no right to use the port. Ask the administrator for this right.</source>
        <translation>此用户无权使用该端口。请向管理员申请权限。</translation>
    </message>
    <message>
        <source>This user has no right to use the port. Add the user to the group &quot;%1&quot; and log in again.</source>
        <translation>此用户无权使用该端口。请把用户加入用户组“%1”并重新登录。</translation>
    </message>
    <message>
        <source>This is not a serial port. Choose another port in the settings.</source>
        <translation>这不是串口。请在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>The port cannot be set up: %1. Choose other settings.</source>
        <translation>端口无法设置：%1。请选择其他设置。</translation>
    </message>
    <message>
        <source>The adapter was removed during the test. Check its plug and cable.</source>
        <translation>测试时适配器被移除。请检查插头和电缆。</translation>
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
        <source>Another program is using this port. Close that program, or choose another port.</source>
        <translation>另一个程序占用了此端口。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>The port is in use by %1. Close that program, or choose another port.</source>
        <translation>端口被 %1 占用。请关闭该程序，或选择其他端口。</translation>
    </message>
    <message>
        <source>%1 of %2, max. %3 min left</source>
        <translation>第 %1 个，共 %2 个，最多还需 %3 分钟</translation>
    </message>
    <message>
        <source>%1 of %2, max. %3 s left</source>
        <translation>第 %1 个，共 %2 个，最多还需 %3 秒</translation>
    </message>
</context>
<context>
    <name>EditorViews</name>
    <message>
        <source>RMS</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 r/min</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation>无界</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 kHz</source>
        <translation>峰值 %1 r/min · %2 · %3 kHz</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>刚好在限值之内。</translation>
    </message>
    <message>
        <source>Within all limits.</source>
        <translation>在所有限值之内。</translation>
    </message>
    <message>
        <source>Within all limits; building the table …</source>
        <translation>在所有限值之内；正在生成数据表…</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>峰值速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>跃度</translation>
    </message>
    <message>
        <source>Torque,
RMS</source>
        <translation>转矩、
均方根</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Error while
sealing</source>
        <translation>封切误差</translation>
    </message>
    <message>
        <source>Vibration
after the move</source>
        <translation>运动后
振动</translation>
    </message>
    <message>
        <source>%1 Nm
RMS %2</source>
        <comment>peak and RMS torque</comment>
        <translation>%1 Nm
均方根 %2</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 Nm (RMS %5) · %4 kHz</source>
        <translation>峰值 %1 r/min · %2 · %3 Nm（均方根 %5） · %4 kHz</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 kHz · seal %4 ms</source>
        <translation>峰值 %1 r/min · %2 · %3 kHz · 封口 %4 ms</translation>
    </message>
    <message>
        <source>Max. master speed</source>
        <translation>主轴最高速度</translation>
    </message>
    <message>
        <source>Rate at max. line speed</source>
        <translation>线速最高时的速率</translation>
    </message>
    <message>
        <source>An encoder leads: the line travels %1 of film at this rate. The run ends above %2.</source>
        <translation>编码器为主轴：此速率下生产线的膜速为 %1。超过 %2 时运行结束。</translation>
    </message>
</context>
<context>
    <name>FileErrorText</name>
    <message>
        <source>The file %1 does not exist. Check its name.</source>
        <translation>文件 %1 不存在。请检查文件名。</translation>
    </message>
    <message>
        <source>The file %1 cannot be read: %2.</source>
        <translation>文件 %1 无法读取：%2。</translation>
    </message>
    <message>
        <source>The recipe could not be saved to %1: %2; the stored recipe is unchanged. Free disk space or check the permissions, then save again.</source>
        <translation>配方无法保存到 %1：%2；已存储的配方没有改变。请腾出空间或检查权限，然后重新保存。</translation>
    </message>
    <message>
        <source>The file %1 is damaged at byte %2: %3. Restore it from a copy.</source>
        <translation>文件 %1 在第 %2 字节处损坏：%3。请从副本恢复。</translation>
    </message>
    <message>
        <source>%1 is not a CamPanel recipe: the key &quot;format&quot; must be &quot;campanel-recipe&quot;.</source>
        <translation>%1 不是 CamPanel 配方：键 &quot;format&quot; 必须为 &quot;campanel-recipe&quot;。</translation>
    </message>
    <message>
        <source>The file %1 has format version %2, this program reads versions up to %3. Update the program.</source>
        <translation>文件 %1 的格式版本为 %2，本程序最高读取版本 %3。请升级程序。</translation>
    </message>
    <message>
        <source>The file %1 has an unknown key %2. Correct or remove the key.</source>
        <translation>文件 %1 中有未知的键 %2。请更正或删除该键。</translation>
    </message>
    <message>
        <source>The file %1 lacks the key %2. Add the key.</source>
        <translation>文件 %1 中缺少键 %2。请补上。</translation>
    </message>
    <message>
        <source>In the file %1, %2 must be %3.</source>
        <translation>文件 %1 中的 %2 必须是%3。</translation>
    </message>
    <message>
        <source>In the file %1, %2 is %3; enter %4.</source>
        <translation>文件 %1 中的 %2 为 %3，请输入 %4。</translation>
    </message>
    <message>
        <source>In the file %1, %2 is &quot;%3&quot;; choose one of: %4.</source>
        <translation>文件 %1 中的 %2 为“%3”，请从以下选择：%4。</translation>
    </message>
    <message>
        <source>In the file %1, %2 is longer than %3 bytes. Shorten the text.</source>
        <translation>文件 %1 中的 %2 超过 %3 字节。请缩短。</translation>
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
        <source>a list of two of bag_length_mm, rate_bags_per_min, base_speed_mm_per_s, film_speed_mm_per_s</source>
        <translation>bag_length_mm、rate_bags_per_min、base_speed_mm_per_s、film_speed_mm_per_s 中的两项</translation>
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
        <source>pairs of master angle and position</source>
        <translation>主轴角和位置的数对</translation>
    </message>
    <message>
        <source>%1 values, as in the header</source>
        <translation>与表头一致的 %1 个值</translation>
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
        <source>The file %1 is not UTF-8 text. Save the file as CSV in UTF-8.</source>
        <translation>文件 %1 不是 UTF-8 文本。请另存为 UTF-8 编码的 CSV。</translation>
    </message>
    <message>
        <source>%1, line %2: expected %3, found &quot;%4&quot;.</source>
        <translation>%1 第 %2 行：应为%3，实际为“%4”。</translation>
    </message>
    <message>
        <source>The file %1 cannot be written: %2.</source>
        <translation>文件 %1 无法写入：%2。</translation>
    </message>
    <message>
        <source>This panel</source>
        <translation>本面板</translation>
    </message>
    <message>
        <source>%1 Free some space, unlock the stick or choose another location.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1请腾出空间、解除 U 盘的写保护，或选择其他位置。</translation>
    </message>
    <message>
        <source>The file %1 has the key %2 twice. Remove one of them.</source>
        <translation>文件 %1 中的键 %2 出现了两次。请删除其中一个。</translation>
    </message>
    <message>
        <source>The file %1 is signed by %2, whose key this machine does not have. Ask Service to install the key, or have it signed by somebody else.</source>
        <translation>文件 %1 由 %2 签名，但本机没有其密钥。请让维修人员安装该密钥，或由其他人签名。</translation>
    </message>
    <message>
        <source>The file %1 is signed by %2, whose key was withdrawn. Have it signed with a valid key.</source>
        <translation>文件 %1 由 %2 签名，其密钥已被撤销。请用有效的密钥重新签名。</translation>
    </message>
    <message>
        <source>The file %1 does not match the signature of %2: it was changed, or another key signed it. Ask for a new copy.</source>
        <translation>文件 %1 与 %2 的签名不符：文件被更改过，或由其他密钥签名。请索取新的副本。</translation>
    </message>
    <message>
        <source>not a regular file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>larger than 1 MB</source>
        <translation>大于 1 MB</translation>
    </message>
    <message>
        <source>the header %1</source>
        <translation>表头 %1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>a list of objects</source>
        <translation>对象列表</translation>
    </message>
    <message>
        <source>The file %1 is not signed; the plant&apos;s network offers signed files only. Have it signed.</source>
        <translation>文件 %1 没有签名；工厂网络只提供已签名的文件。请先签名。</translation>
    </message>
    <message>
        <source>Plant network</source>
        <translation>工厂网络</translation>
    </message>
    <message>
        <source>In the file %1, %2 has the character %3, which nobody can see. Remove the character.</source>
        <translation>文件 %1 中 %2 含有不可见字符 %3。请删除该字符。</translation>
    </message>
    <message>
        <source>a text of visible characters</source>
        <translation>由可见字符组成的文本</translation>
    </message>
    <message>
        <source>%1 does not answer. Check the network or plug the stick in again.</source>
        <translation>%1 无响应。请检查网络，或重新插入 U 盘。</translation>
    </message>
    <message>
        <source>%1 older files of %2 are not shown. Delete files that are not needed, or move them into a folder.</source>
        <translation>%2 中有 %1 个较旧的文件未显示。请删除不需要的文件，或将其移入文件夹。</translation>
    </message>
</context>
<context>
    <name>FrameWords</name>
    <message>
        <source>Sent</source>
        <translation>已发送</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>被控制器拒绝</translation>
    </message>
    <message>
        <source>Dropped: response to another request</source>
        <translation>已丢弃：其他请求的应答</translation>
    </message>
    <message>
        <source>Dropped: wrong checksum</source>
        <translation>已丢弃：校验和错误</translation>
    </message>
    <message>
        <source>Dropped: invalid frame</source>
        <translation>已丢弃：无效报文</translation>
    </message>
    <message>
        <source>Dropped: incomplete frame</source>
        <translation>已丢弃：报文不完整</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>应答超时</translation>
    </message>
    <message>
        <source>Skipped: stray bytes</source>
        <translation>已跳过：多余字节</translation>
    </message>
    <message>
        <source>Dropped: no request pending</source>
        <translation>已丢弃：没有对应的请求</translation>
    </message>
    <message>
        <source>Port removed</source>
        <translation>端口已移除</translation>
    </message>
    <message>
        <source>Status request, heartbeat %1</source>
        <translation>请求状态，心跳 %1</translation>
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
        <source>Response: done</source>
        <translation>应答：完成</translation>
    </message>
    <message>
        <source>Response: %1</source>
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
    <name>Language</name>
    <message>
        <source>English</source>
        <extracomment>The name of the language in the language itself; without it the file is not used.</extracomment>
        <translation>简体中文</translation>
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
    <name>MasterSentences</name>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Place of the encoder</source>
        <translation>编码器位置</translation>
    </message>
    <message>
        <source>Signal of the encoder</source>
        <translation>编码器信号</translation>
    </message>
    <message>
        <source>Encoder counts backward</source>
        <translation>编码器反向计数</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>每转计数</translation>
    </message>
    <message>
        <source>Film per revolution</source>
        <translation>每转膜长</translation>
    </message>
    <message>
        <source>Delay compensation</source>
        <translation>延时补偿</translation>
    </message>
    <message>
        <source>Delay of the drive</source>
        <translation>驱动器延时</translation>
    </message>
    <message>
        <source>Time constant of the position</source>
        <translation>位置时间常数</translation>
    </message>
    <message>
        <source>Stretch for engaging</source>
        <translation>接合距离</translation>
    </message>
    <message>
        <source>Max. speed of the master</source>
        <translation>主轴最高速度</translation>
    </message>
    <message>
        <source>Cam follows backward</source>
        <translation>凸轮跟随反向</translation>
    </message>
    <message>
        <source>Limit of the index mark</source>
        <translation>零位信号限值</translation>
    </message>
    <message>
        <source>Limit of the wheel&apos;s slip</source>
        <translation>测量轮打滑限值</translation>
    </message>
    <message>
        <source>Phase of the line</source>
        <translation>生产线相位</translation>
    </message>
    <message>
        <source>This recipe is for an encoder as the master, and the controller has no input for one. Change the master of the recipe, or use another controller.</source>
        <translation>此配方以编码器为主轴，而控制器没有编码器输入。请更改配方的主轴，或使用其他控制器。</translation>
    </message>
    <message>
        <source>This recipe is for an encoder as the master, but the machine follows its clock. Set the encoder as the master of the machine, or change the master of the recipe.</source>
        <translation>此配方以编码器为主轴，但机器跟随时钟。请将机器的主轴设为编码器，或更改配方的主轴。</translation>
    </message>
    <message>
        <source>This recipe is for the clock, but an encoder leads the machine. Set the clock as the master of the machine, or change the master of the recipe.</source>
        <translation>此配方以时钟为主轴，但机器跟随编码器。请将机器的主轴设为时钟，或更改配方的主轴。</translation>
    </message>
    <message>
        <source>As the machine</source>
        <translation>与机器相同</translation>
    </message>
    <message>
        <source>Clock of the controller</source>
        <translation>控制器时钟</translation>
    </message>
    <message>
        <source>Encoder of the line</source>
        <translation>生产线编码器</translation>
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
        <source>The line sets the rate: an encoder leads the machine. Change the speed of the line.</source>
        <translation>速率由生产线决定：编码器为主轴。请改变生产线的速度。</translation>
    </message>
</context>
<context>
    <name>NetworkAddress</name>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Subnet mask</source>
        <translation>子网掩码</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>网关</translation>
    </message>
    <message>
        <source>DNS server</source>
        <translation>DNS 服务器</translation>
    </message>
    <message>
        <source>Four numbers from 0 to 255, such as 192.168.1.20. Each device has its own.</source>
        <translation>四个 0 到 255 的数，例如 192.168.1.20。每台设备的地址各不相同。</translation>
    </message>
    <message>
        <source>A mask, such as 255.255.255.0, or its length, such as 24.</source>
        <translation>掩码，例如 255.255.255.0；或其长度，例如 24。</translation>
    </message>
    <message>
        <source>The device that leads to other networks. Empty: none.</source>
        <translation>通往其他网络的设备。留空：无。</translation>
    </message>
    <message>
        <source>The device that knows the names of computers. Empty: none.</source>
        <translation>解析计算机名称的设备。留空：无。</translation>
    </message>
    <message>
        <source>Not a subnet mask. Enter a mask from 128.0.0.0 to 255.255.255.252, or its length from 1 to 30.</source>
        <translation>不是子网掩码。请输入 128.0.0.0 到 255.255.255.252 的掩码，或 1 到 30 的长度。</translation>
    </message>
    <message>
        <source>Not an IPv4 address. Enter four numbers from 0 to 255 with points between them.</source>
        <translation>不是 IPv4 地址。请输入四个 0 到 255 的数，中间用点隔开。</translation>
    </message>
    <message>
        <source>No device has this address. The first number is from 1 to 223, and not 127.</source>
        <translation>设备不能使用此地址。第一个数应为 1 到 223，且不是 127。</translation>
    </message>
    <message>
        <source>%1 is the subnet itself. Enter an address from %2 to %3, or another mask.</source>
        <translation>%1 是子网本身。请输入 %2 到 %3 的地址，或更改掩码。</translation>
    </message>
    <message>
        <source>%1 is the broadcast address. Enter an address from %2 to %3, or another mask.</source>
        <translation>%1 是广播地址。请输入 %2 到 %3 的地址，或更改掩码。</translation>
    </message>
    <message>
        <source>The gateway has the address of this panel. Enter the gateway&apos;s address, or none.</source>
        <translation>网关与本面板地址相同。请输入网关的地址，或留空。</translation>
    </message>
    <message>
        <source>The gateway is not in the subnet. Enter a gateway from %1 to %2, or another mask.</source>
        <translation>网关不在子网内。请输入 %1 到 %2 的网关，或更改掩码。</translation>
    </message>
</context>
<context>
    <name>OrderWords</name>
    <message>
        <source>Queued</source>
        <translation>排队中</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Ended early</source>
        <translation>提前结束</translation>
    </message>
    <message>
        <source>The run goes on</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>Message %1 bags before the end</source>
        <translation>结束前 %1 袋提示</translation>
    </message>
    <message>
        <source>The run stops</source>
        <translation>停止运行</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>订单 %1</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>good bags of an order</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>自 %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>started by %1</source>
        <translation>开始人 %1</translation>
    </message>
    <message>
        <source>first bag checked by %1</source>
        <translation>首袋检查人 %1</translation>
    </message>
    <message>
        <source>The lot has a character that nobody sees. Enter one line of visible characters.</source>
        <translation>批号含有不可见字符。请输入一行可见字符。</translation>
    </message>
    <message>
        <source>The lot is too long: %1 bytes, at most %2 fit. A letter of another script has two or more.</source>
        <translation>批号过长：%1 字节，最多 %2 字节。一个汉字占三个字节。</translation>
    </message>
    <message>
        <source>The text has a character that nobody sees. Enter one line of visible characters.</source>
        <translation>文本含有不可见字符。请输入一行可见字符。</translation>
    </message>
    <message>
        <source>The text is too long: %1 characters, at most %2 fit.</source>
        <translation>文本过长：%1 个字符，最多 %2 个。</translation>
    </message>
    <message>
        <source>This controller counts no orders: its register map is %1, orders need %2.</source>
        <translation>此控制器不统计订单：其寄存器表为 %1，订单需要 %2。</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>%1 m of film</source>
        <translation>薄膜 %1 m</translation>
    </message>
</context>
<context>
    <name>PackageSentences</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is not a Debian package.</source>
        <translation>%1 不是 Debian 软件包。</translation>
    </message>
    <message>
        <source>%1 has no signature. Copy the file %1.sig beside it.</source>
        <translation>%1 没有签名。请把文件 %1.sig 复制到同一位置。</translation>
    </message>
    <message>
        <source>%1 is signed by %2, whose key this machine does not have. Install the key first.</source>
        <translation>%1 由 %2 签名，但本机没有其密钥。请先安装密钥。</translation>
    </message>
    <message>
        <source>%1 is signed by %2, whose key was withdrawn. Ask for a package signed with a valid key.</source>
        <translation>%1 由 %2 签名，但其密钥已作废。请索取用有效密钥签名的软件包。</translation>
    </message>
    <message>
        <source>The signature of %1 is not valid. Ask for a new copy of both files.</source>
        <translation>%1 的签名无效。请重新索取这两个文件。</translation>
    </message>
    <message>
        <source>The signature of %1 has a newer form than this CamPanel knows. Install a version in between first.</source>
        <translation>%1 的签名格式比本版 CamPanel 支持的更新。请先安装中间版本。</translation>
    </message>
    <message>
        <source>%1 is damaged or was changed after it was signed. Copy the file again.</source>
        <translation>%1 已损坏，或签名后被修改。请重新复制该文件。</translation>
    </message>
    <message>
        <source>This package is for computers of type %1; this panel has %2.</source>
        <translation>此软件包适用于 %1 型计算机；本面板为 %2。</translation>
    </message>
    <message>
        <source>Version %1 is older than the installed version %2.</source>
        <translation>版本 %1 比已安装的版本 %2 旧。</translation>
    </message>
    <message>
        <source>Version %1 is installed.</source>
        <translation>版本 %1 已安装。</translation>
    </message>
    <message>
        <source>not readable</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>no package</source>
        <translation>不是软件包</translation>
    </message>
    <message>
        <source>no signature</source>
        <translation>没有签名</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>未知密钥</translation>
    </message>
    <message>
        <source>withdrawn key</source>
        <translation>密钥已作废</translation>
    </message>
    <message>
        <source>wrong signature</source>
        <translation>签名错误</translation>
    </message>
    <message>
        <source>unknown form of signature</source>
        <translation>未知签名格式</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>for another type of computer</source>
        <translation>适用于其他类型的计算机</translation>
    </message>
    <message>
        <source>older version</source>
        <translation>旧版本</translation>
    </message>
    <message>
        <source>installed</source>
        <translation>已安装</translation>
    </message>
    <message>
        <source>The package is not signed by a key of this machine.</source>
        <translation>此软件包未用本机信任的密钥签名。</translation>
    </message>
    <message>
        <source>The package is not a newer CamPanel for this machine.</source>
        <translation>此软件包不是适用于本机的更新版 CamPanel。</translation>
    </message>
    <message>
        <source>The package needs other packages, which the stick cannot bring: %1. Install them by the package manager first.</source>
        <translation>此软件包需要其他软件包，无法由 U 盘提供：%1。请先用软件包管理器安装。</translation>
    </message>
    <message>
        <source>The package of the installed version %1 is missing, so there would be no way back. Copy it and its signature to the stick as well.</source>
        <translation>缺少已安装版本 %1 的软件包，更新后将无法恢复。请把它及其签名也复制到 U 盘。</translation>
    </message>
    <message>
        <source>%1 MB of free space are needed on this panel.</source>
        <translation>本面板需要 %1 MB 可用空间。</translation>
    </message>
    <message>
        <source>Another installation is under way on this panel. Wait until it has ended.</source>
        <translation>本面板上正在进行另一项安装。请等待其结束。</translation>
    </message>
    <message>
        <source>A program of the panel&apos;s user did not end. Switch the panel off and on, then try again.</source>
        <translation>面板用户的一个程序未能结束。请关闭面板电源再打开，然后重试。</translation>
    </message>
    <message>
        <source>The panel&apos;s data could not be copied. Read journalctl -u campanel-update.</source>
        <translation>面板数据无法复制。请查看 journalctl -u campanel-update。</translation>
    </message>
    <message>
        <source>The earlier version is not kept on this panel any more.</source>
        <translation>本面板上已不再保留旧版本。</translation>
    </message>
    <message>
        <source>The new version did not open its window.</source>
        <translation>新版本未能打开窗口。</translation>
    </message>
    <message>
        <source>The new version could not be installed.</source>
        <translation>无法安装新版本。</translation>
    </message>
    <message>
        <source>The files could not be read.</source>
        <translation>无法读取文件。</translation>
    </message>
    <message>
        <source>This is the package %1; this panel takes %2.</source>
        <translation>这是软件包 %1；此面板使用 %2。</translation>
    </message>
    <message>
        <source>another package</source>
        <translation>其他软件包</translation>
    </message>
    <message>
        <source>The system is larger than its place on the card. Make a backup, then write the new image to the card.</source>
        <translation>系统大于存储卡上的预留空间。请先备份，再将新映像写入存储卡。</translation>
    </message>
    <message>
        <source>The firmware of this computer cannot start a system once, so there would be no way back. Make a backup, then write the new image to the card.</source>
        <translation>此计算机的固件不能只启动一次新系统，因此无法返回旧版本。请先备份，再将新映像写入存储卡。</translation>
    </message>
</context>
<context>
    <name>Protocol</name>
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
        <source>Reference run</source>
        <translation>回零中</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>At standstill</source>
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
        <source>Stop position outside tolerance</source>
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
        <source>Contact too early</source>
        <translation>过早接触工件</translation>
    </message>
    <message>
        <source>No contact</source>
        <translation>未接触到工件</translation>
    </message>
    <message>
        <source>Max. force reached</source>
        <translation>达到最大力</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>中途停止</translation>
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
        <source>Reset fault</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Measure marks</source>
        <translation>测量色标</translation>
    </message>
    <message>
        <source>The lead of cam switch %1 is longer than a cycle. Shorten it under Maintenance, or lower the rate.</source>
        <translation>凸轮开关 %1 的提前时间超过一个周期。请在“维护”中缩短提前时间，或降低速率。</translation>
    </message>
    <message>
        <source>The controller does not support this command. Update its firmware.</source>
        <translation>控制器不支持此命令。请升级其固件。</translation>
    </message>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>控制器没有程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The machine is already moving. Stop it first.</source>
        <translation>机器已在运动。请先停机。</translation>
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
        <source>The controller has no checked table. Download again.</source>
        <translation>控制器没有通过检查的数据表。请重新下载。</translation>
    </message>
    <message>
        <source>Another download interfered. Download again.</source>
        <translation>期间有另一次下载。请重新下载。</translation>
    </message>
    <message>
        <source>The controller received different data. Download again.</source>
        <translation>控制器收到的数据不同。请重新下载。</translation>
    </message>
    <message>
        <source>Machine data can only be changed at standstill. Stop the machine first.</source>
        <translation>机器数据只能在静止时更改。请先停机。</translation>
    </message>
    <message>
        <source>No change is pending.</source>
        <translation>没有等待生效的更改。</translation>
    </message>
    <message>
        <source>Writing to the controller&apos;s flash failed; the saved program is unchanged. Save again.</source>
        <translation>控制器闪存写入失败，已保存的程序没有改变。请重新保存。</translation>
    </message>
    <message>
        <source>There is no fault to reset.</source>
        <translation>没有需要复位的故障。</translation>
    </message>
    <message>
        <source>The controller does not accept this value. Update the older of panel and controller.</source>
        <translation>控制器不接受此值。请升级面板与控制器中较旧的一方。</translation>
    </message>
    <message>
        <source>The cause of the fault still exists. Remove it first.</source>
        <translation>故障原因仍然存在。请先排除。</translation>
    </message>
    <message>
        <source>The controller receives no heartbeat from the panel. Check the cable.</source>
        <translation>控制器收不到面板的心跳。请检查电缆。</translation>
    </message>
    <message>
        <source>There are too many bags between mark sensor and knife. Set a longer bag, move the sensor closer, or switch off mark tracking under Maintenance.</source>
        <translation>色标传感器与切刀之间的袋数过多。请设定更长的袋长、移近传感器，或在“维护”中关闭色标跟踪。</translation>
    </message>
    <message>
        <source>The mark window is wider than half a bag. Reduce it under Maintenance.</source>
        <translation>色标窗口宽于半个袋长。请在“维护”中缩小窗口。</translation>
    </message>
    <message>
        <source>The sync window is too long to correct the film. Change k1 to k4.</source>
        <translation>同步区过长，没有时间修正薄膜。请更改 k1 至 k4。</translation>
    </message>
    <message>
        <source>The product eye is too close or too far to decide in time. Check its distance under Maintenance.</source>
        <translation>产品光电离切刀过近或过远，来不及判断。请在“维护”中检查其距离。</translation>
    </message>
    <message>
        <source>Film or infeed would exceed the controller&apos;s speed limit. Lower the rate.</source>
        <translation>薄膜或进料的速度将超过控制器的限值。请降低速率。</translation>
    </message>
    <message>
        <source>Another device on the line writes parts of commands. Check the connected devices.</source>
        <translation>线路上有另一设备分段写入命令。请检查所连接的设备。</translation>
    </message>
    <message>
        <source>The speed of an axis would change too abruptly. Stop the machine, then download; or raise the largest speed steps under Maintenance.</source>
        <translation>轴的速度突变过大。请先停机再下载，或在“维护”中增大最大速度阶跃。</translation>
    </message>
    <message>
        <source>Parts of the table are missing. Download again.</source>
        <translation>数据表不完整。请重新下载。</translation>
    </message>
    <message>
        <source>Panel and controller do not match. Update the older device.</source>
        <translation>面板与控制器不匹配。请升级较旧的一方。</translation>
    </message>
    <message>
        <source>Value %1 in the table header is outside the controller&apos;s limits. Correct the recipe.</source>
        <translation>数据表头的第 %1 个值超出控制器的限值。请更正配方。</translation>
    </message>
    <message>
        <source>Row %1 of the table is outside the range of the controller&apos;s timer. Lower the rate.</source>
        <translation>数据表第 %1 行超出控制器定时器的范围。请降低速率。</translation>
    </message>
    <message>
        <source>The table&apos;s rows do not match its total pulses and time. Download again.</source>
        <translation>数据表各行之和与总脉冲数和总时间不符。请重新下载。</translation>
    </message>
    <message>
        <source>An earlier change is waiting for the end of the cycle. Cancel it first.</source>
        <translation>之前的更改仍在等待周期结束。请先取消该更改。</translation>
    </message>
    <message>
        <source>The controller has not finished checking or saving a table. Download again.</source>
        <translation>控制器尚未完成表格的检查或保存。请重新下载。</translation>
    </message>
    <message>
        <source>Mark tracking off</source>
        <translation>色标跟踪关闭</translation>
    </message>
    <message>
        <source>Searching for marks</source>
        <translation>正在寻找色标</translation>
    </message>
    <message>
        <source>Aligning cuts with marks</source>
        <translation>正在将切断对准色标</translation>
    </message>
    <message>
        <source>Tracking marks</source>
        <translation>正在跟踪色标</translation>
    </message>
    <message>
        <source>Product in the knife&apos;s path</source>
        <translation>产品挡住切刀</translation>
    </message>
    <message>
        <source>Product longer than the bag</source>
        <translation>产品长于袋长</translation>
    </message>
    <message>
        <source>Product missing</source>
        <translation>缺少产品</translation>
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
        <source>acknowledged, in progress</source>
        <translation>已确认，正在处理</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>设备忙</translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation>存储器奇偶校验错误</translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation>网关路径不可用</translation>
    </message>
    <message>
        <source>no response from the device behind the gateway</source>
        <translation>网关之后的设备无应答</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>By angle</source>
        <translation>按角度</translation>
    </message>
    <message>
        <source>Rejected bags</source>
        <translation>剔除袋</translation>
    </message>
    <message>
        <source>Always on</source>
        <translation>常开</translation>
    </message>
    <message>
        <source>While running</source>
        <translation>运行时</translation>
    </message>
    <message>
        <source>Drive alarm</source>
        <translation>驱动器报警</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Limit switch, forward</source>
        <translation>正向限位开关</translation>
    </message>
    <message>
        <source>Limit switch, reverse</source>
        <translation>反向限位开关</translation>
    </message>
    <message>
        <source>Index mark</source>
        <translation>零位标记</translation>
    </message>
    <message>
        <source>Mark sensor</source>
        <translation>色标传感器</translation>
    </message>
    <message>
        <source>Product eye</source>
        <translation>产品光电</translation>
    </message>
    <message>
        <source>Cam switch %1</source>
        <translation>凸轮开关 %1</translation>
    </message>
    <message>
        <source>Drive enable</source>
        <translation>驱动器使能</translation>
    </message>
    <message>
        <source>following</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>decelerating</source>
        <translation>减速中</translation>
    </message>
    <message>
        <source>at standstill</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>accelerating</source>
        <translation>加速中</translation>
    </message>
    <message>
        <source>The emergency stop is pressed. Release it, then wait two seconds.</source>
        <translation>急停已按下。请松开急停，然后等待两秒。</translation>
    </message>
    <message>
        <source>The drive reported an alarm. Remove its cause, then reset the fault.</source>
        <translation>驱动器曾报警。请排除原因，然后复位故障。</translation>
    </message>
    <message>
        <source>The panel does not permit the start: the machine is not warm. Wait until it is warm.</source>
        <translation>面板不允许启动：机器尚未预热。请等待预热完成。</translation>
    </message>
    <message>
        <source>The panel does not permit the start with this film reel. Load and scan the right reel.</source>
        <translation>面板不允许用此膜卷启动。请装上并扫描正确的膜卷。</translation>
    </message>
    <message>
        <source>The panel does not permit the start with this program. Download the recipe again.</source>
        <translation>面板不允许用此程序启动。请重新下载配方。</translation>
    </message>
    <message>
        <source>The panel does not permit motion while the machine is cleaned. End the cleaning first.</source>
        <translation>清洁机器时面板不允许运动。请先结束清洁。</translation>
    </message>
    <message>
        <source>The panel does not permit the start. Read the reason at its Start button.</source>
        <translation>面板不允许启动。请查看其启动键处的原因。</translation>
    </message>
    <message>
        <source>NO contact</source>
        <translation>常开</translation>
    </message>
    <message>
        <source>NC contact</source>
        <translation>常闭</translation>
    </message>
    <message>
        <source>The drive reports an alarm. The controller goes into fault.</source>
        <translation>驱动器报警，控制器进入故障状态。</translation>
    </message>
    <message>
        <source>Ends a motion and refuses others. No safety depends on this.</source>
        <translation>结束运动并拒绝其他运动。安全不依赖于此。</translation>
    </message>
    <message>
        <source>The axis is at its forward limit. Only displayed.</source>
        <translation>轴在正向极限位置。仅显示。</translation>
    </message>
    <message>
        <source>The axis is at its reverse limit. Only displayed.</source>
        <translation>轴在反向极限位置。仅显示。</translation>
    </message>
    <message>
        <source>The axis is on its index mark.</source>
        <translation>轴在零位标记上。</translation>
    </message>
    <message>
        <source>A printed mark is under the sensor.</source>
        <translation>传感器下有色标。</translation>
    </message>
    <message>
        <source>A product covers the eye.</source>
        <translation>产品挡住光电。</translation>
    </message>
    <message>
        <source>On by the angle of the cycle, or for a rejected bag.</source>
        <translation>按周期角度接通，或因剔除袋接通。</translation>
    </message>
    <message>
        <source>Enables the drives of all axes.</source>
        <translation>使能所有轴的驱动器。</translation>
    </message>
    <message>
        <source>Try output</source>
        <translation>测试输出</translation>
    </message>
    <message>
        <source>The distance in which prints behind a mark are ignored reaches the next mark. Reduce it under Maintenance.</source>
        <translation>色标后的屏蔽距离已到达下一个色标。请在“维护”中减小。</translation>
    </message>
    <message>
        <source>The minimum mark width is above the maximum. Correct it under Maintenance.</source>
        <translation>色标最小宽度大于最大宽度。请在“维护”中更正。</translation>
    </message>
    <message>
        <source>Torque limit</source>
        <translation>转矩限制</translation>
    </message>
    <message>
        <source>The drive is at its torque limit. While the jaws close, this is a jam.</source>
        <translation>驱动器达到转矩限制。封切口闭合期间即为卡料。</translation>
    </message>
    <message>
        <source>The drive reports no torque</source>
        <translation>驱动器不报告转矩</translation>
    </message>
    <message>
        <source>The drive reports its torque too seldom</source>
        <translation>驱动器报告转矩的频率太低</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>学习中</translation>
    </message>
    <message>
        <source>Monitored</source>
        <translation>监控中</translation>
    </message>
    <message>
        <source>The angles at which the jaws touch the film leave out the cut. Enter both under Maintenance, or 0 for both.</source>
        <translation>封切口接触薄膜的角度未包含切断点。请在“维护”中输入两个角度，或都设为 0。</translation>
    </message>
    <message>
        <source>The controller has no input for an encoder as the master. Set the clock as the master, or use another controller.</source>
        <translation>控制器没有主轴编码器输入。请将主轴设为时钟，或更换控制器。</translation>
    </message>
    <message>
        <source>The line runs faster than this program. Slow it down, or download a faster program.</source>
        <translation>生产线比此程序更快。请降低生产线速度，或下载更快的程序。</translation>
    </message>
    <message>
        <source>This program cannot follow an encoder. Set the clock as the master to run it.</source>
        <translation>此程序不能跟随编码器。请将主轴设为时钟后再运行。</translation>
    </message>
    <message>
        <source>Not engaged</source>
        <translation>未接合</translation>
    </message>
    <message>
        <source>Engaging</source>
        <translation>正在接合</translation>
    </message>
    <message>
        <source>Engaged</source>
        <translation>已接合</translation>
    </message>
    <message>
        <source>Disengaging</source>
        <translation>正在脱开</translation>
    </message>
    <message>
        <source>Line may run</source>
        <translation>生产线可运行</translation>
    </message>
    <message>
        <source>On while the knife follows the encoder on the film, or waits for it.</source>
        <translation>切刀跟随薄膜上的编码器或等待它时为开。</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>转轴</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>测量轮</translation>
    </message>
    <message>
        <source>A/B</source>
        <translation>A/B</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>Start of an order</source>
        <translation>订单开始</translation>
    </message>
    <message>
        <source>End of an order</source>
        <translation>订单结束</translation>
    </message>
    <message>
        <source>Another order is under way. End it first.</source>
        <translation>另一个订单正在进行。请先结束它。</translation>
    </message>
    <message>
        <source>This order is not under way.</source>
        <translation>该订单未在进行。</translation>
    </message>
    <message>
        <source>No order</source>
        <translation>无订单</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Ended early</source>
        <translation>提前结束</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Start button</source>
        <translation>启动按钮</translation>
    </message>
    <message>
        <source>Starts a run when it is pressed, as Start on the panel does.</source>
        <translation>按下时启动运行，与面板上的“启动”相同。</translation>
    </message>
    <message>
        <source>Stop button</source>
        <translation>停止按钮</translation>
    </message>
    <message>
        <source>Ends a run at the end of its cycle and refuses a start.</source>
        <translation>在周期结束时结束运行，并禁止启动。</translation>
    </message>
    <message>
        <source>Door open</source>
        <translation>门已打开</translation>
    </message>
    <message>
        <source>Ends a run at once and refuses a start. No safety depends on this.</source>
        <translation>立即结束运行并禁止启动。不承担安全功能。</translation>
    </message>
    <message>
        <source>Next machine not ready</source>
        <translation>下游设备未就绪</translation>
    </message>
    <message>
        <source>Date coder not ready</source>
        <translation>打码机未就绪</translation>
    </message>
    <message>
        <source>On or blinking by the table of the light tower.</source>
        <translation>按信号灯表接通或闪烁。</translation>
    </message>
    <message>
        <source>Light tower, red</source>
        <translation>信号灯，红</translation>
    </message>
    <message>
        <source>Light tower, yellow</source>
        <translation>信号灯，黄</translation>
    </message>
    <message>
        <source>Light tower, green</source>
        <translation>信号灯，绿</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>蜂鸣器</translation>
    </message>
    <message>
        <source>Machine runs</source>
        <translation>设备运行</translation>
    </message>
    <message>
        <source>On from the start of a run to its standstill.</source>
        <translation>从运行启动到停止期间接通。</translation>
    </message>
    <message>
        <source>Acknowledgement</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>The Stop button of the machine is pressed. Release it.</source>
        <translation>设备的停止按钮已按下。请松开。</translation>
    </message>
    <message>
        <source>The door is open. Close it.</source>
        <translation>门已打开。请关门。</translation>
    </message>
    <message>
        <source>The next machine is not ready. Clear it first.</source>
        <translation>下游设备未就绪。请先排除原因。</translation>
    </message>
    <message>
        <source>The date coder is not ready. Clear its fault first.</source>
        <translation>打码机未就绪。请先排除其故障。</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>闪烁</translation>
    </message>
    <message>
        <source>Blinks, then on</source>
        <translation>闪烁后常亮</translation>
    </message>
    <message>
        <source>On, then off</source>
        <translation>接通后关闭</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Order complete</source>
        <translation>订单完成</translation>
    </message>
    <message>
        <source>One-bag button</source>
        <translation>单袋按钮</translation>
    </message>
    <message>
        <source>Makes one bag when it is pressed at standstill.</source>
        <translation>静止时按下，生产一袋。</translation>
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
        <source>The active program makes no bags. Download a cutter&apos;s program to a packing machine first.</source>
        <translation>当前程序不生产袋子。请先将切刀程序下载到包装机。</translation>
    </message>
    <message>
        <source>The knife is not in its place. Make a reference run first.</source>
        <translation>切刀不在其位置。请先回零。</translation>
    </message>
    <message>
        <source>The line in front drives the film, so no single bag can be made.</source>
        <translation>薄膜由前面的生产线驱动，无法单独生产一袋。</translation>
    </message>
    <message>
        <source>The film moves. Stop the line first.</source>
        <translation>薄膜在运动。请先停止生产线。</translation>
    </message>
    <message>
        <source>No cam switch rejects bags. Set one under Maintenance.</source>
        <translation>没有凸轮开关用于剔除袋子。请在“维护”中设置一个。</translation>
    </message>
    <message>
        <source>A product is under the knife. Run the machine empty first.</source>
        <translation>切刀下有产品。请先将机器运行至排空。</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>可启动</translation>
    </message>
    <message>
        <source>On at standstill while nothing refuses a start.</source>
        <translation>静止且无任何拒绝启动的条件时接通。</translation>
    </message>
    <message>
        <source>Product request</source>
        <translation>请求产品</translation>
    </message>
    <message>
        <source>On in a run while the place at the product eye is free.</source>
        <translation>运行中且产品光电处的位置空着时接通。</translation>
    </message>
    <message>
        <source>Date coder pulse</source>
        <translation>打码机脉冲</translation>
    </message>
    <message>
        <source>One pulse for each product, at its place before the cut.</source>
        <translation>每个产品一个脉冲，在切断前的设定位置发出。</translation>
    </message>
    <message>
        <source>The date coder prints before the products are on the film. Check the place of its pulse under Maintenance &gt; Inputs and outputs.</source>
        <translation>打码机在产品落到膜上之前就打印。请在“维护 &gt; 输入与输出”中检查其脉冲位置。</translation>
    </message>
    <message>
        <source>Film index</source>
        <translation>薄膜零位</translation>
    </message>
    <message>
        <source>On once per turn of the film motor. For measuring it.</source>
        <translation>薄膜电机每转接通一次，用于测量。</translation>
    </message>
    <message>
        <source>Infeed index</source>
        <translation>进料零位</translation>
    </message>
    <message>
        <source>On once per product of the infeed. For measuring it.</source>
        <translation>进料每送一件产品接通一次，用于测量。</translation>
    </message>
    <message>
        <source>Measurement of an axis</source>
        <translation>轴测量</translation>
    </message>
    <message>
        <source>This axis has no index sensor. Connect one under Maintenance &gt; Inputs and outputs, or enter the pulses by hand.</source>
        <translation>该轴没有零位传感器。请在“维护 &gt; 输入与输出”中连接，或手动输入脉冲数。</translation>
    </message>
    <message>
        <source>No index mark came within four turns. Check the index sensor.</source>
        <translation>四转内未出现零位标记。请检查零位传感器。</translation>
    </message>
    <message>
        <source>The jaws hold the film. Jog the knife open first.</source>
        <translation>封切口夹住薄膜。请先点动打开切刀。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
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
        <source>Trapezoid</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>S curve</source>
        <translation>S 形曲线</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>手动设定</translation>
    </message>
    <message>
        <source>Gentle</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>Cool</source>
        <translation>低热</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>低速</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>之间</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>运动规律</translation>
    </message>
    <message>
        <source>Execution</source>
        <translation>执行方式</translation>
    </message>
    <message>
        <source>Shape of the ramp</source>
        <translation>加速曲线形状</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Spline ends</source>
        <translation>样条端点条件</translation>
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
        <source>Segment cam</source>
        <translation>分段凸轮</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>型值点</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>运动段</translation>
    </message>
    <message>
        <source>Exponent k</source>
        <translation>指数 k</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>三次</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps to its peak (6) at both ends; as a speed law, jerk does.</source>
        <translation>用作位移规律时，加速度在两端突变到峰值（6）；用作速度规律时，跃度在两端突变到峰值。</translation>
    </message>
    <message>
        <source>Quintic 3-4-5</source>
        <translation>五次 3-4-5</translation>
    </message>
    <message>
        <source>Speed and acceleration are zero at both ends, with a short polynomial.</source>
        <translation>多项式简短，两端速度和加速度均为零。</translation>
    </message>
    <message>
        <source>Polynomial 4-5-6-7</source>
        <translation>多项式 4-5-6-7</translation>
    </message>
    <message>
        <source>Speed, acceleration and jerk are zero at both ends, which excites little vibration.</source>
        <translation>两端速度、加速度和跃度均为零，激起的振动很小。</translation>
    </message>
    <message>
        <source>This law has the highest peak speed (2.19) and peak acceleration (7.51) of the displacement laws without parameters.</source>
        <translation>在无参数的位移规律中，峰值速度（2.19）和峰值加速度（7.51）最高。</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>简谐</translation>
    </message>
    <message>
        <source>Half a cosine wave gives a low peak speed (1.57) and a low peak acceleration (4.93).</source>
        <translation>由半个余弦波构成，峰值速度低（1.57），峰值加速度低（4.93）。</translation>
    </message>
    <message>
        <source>As a displacement law, full acceleration at start and end causes jolts.</source>
        <translation>用作位移规律时，起止瞬间即为最大加速度，引起冲击。</translation>
    </message>
    <message>
        <source>Cycloidal</source>
        <translation>摆线</translation>
    </message>
    <message>
        <source>Acceleration is one full sine wave: smooth, and zero at both ends.</source>
        <translation>加速度为一个完整的正弦波，全程光滑，两端为零。</translation>
    </message>
    <message>
        <source>Peak speed (2) and peak acceleration (6.28) are high, and jerk jumps at both ends.</source>
        <translation>峰值速度（2）和峰值加速度（6.28）较高，跃度在两端突变。</translation>
    </message>
    <message>
        <source>Modified sine</source>
        <translation>修正正弦</translation>
    </message>
    <message>
        <source>Jerk jumps at both ends and has the highest finite peak (69.5) of the laws without parameters.</source>
        <translation>跃度在两端突变，其有限峰值（69.5）在无参数规律中最高。</translation>
    </message>
    <message>
        <source>Modified trapezoid</source>
        <translation>修正梯形</translation>
    </message>
    <message>
        <source>This law has the lowest peak acceleration (4.89) of the laws without parameters and acceleration jumps.</source>
        <translation>在加速度无突变的无参数规律中，峰值加速度最低（4.89）。</translation>
    </message>
    <message>
        <source>Peak speed (2) and peak jerk (61.4) are high, and jerk jumps at both ends.</source>
        <translation>峰值速度（2）和峰值跃度（61.4）较高，跃度在两端突变。</translation>
    </message>
    <message>
        <source>Parabolic</source>
        <translation>抛物线</translation>
    </message>
    <message>
        <source>This law has the lowest possible peak acceleration (4) from rest to rest.</source>
        <translation>从静止到静止的运动所能达到的最低峰值加速度（4）。</translation>
    </message>
    <message>
        <source>At the same peak acceleration, no law has a lower peak speed; the ramp fraction trades one for the other.</source>
        <translation>峰值加速度相同时，没有规律的峰值速度更低；用斜坡比例在二者之间取舍。</translation>
    </message>
    <message>
        <source>Seven-segment S</source>
        <translation>七段 S 形</translation>
    </message>
    <message>
        <source>Acceleration does not jump; the peaks of acceleration and jerk can be set.</source>
        <translation>加速度无突变，加速度和跃度的峰值均可设定。</translation>
    </message>
    <message>
        <source>Exponential</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>Acceleration is highest at low speed, where the motor has the most torque, and lowest near the end speed.</source>
        <translation>低速时电机转矩最充裕，加速度最大；接近终了速度时加速度最小。</translation>
    </message>
    <message>
        <source>Acceleration jumps at both ends; a larger k increases the jump at the low speed.</source>
        <translation>加速度在两端突变；k 越大，低速端的突变越大。</translation>
    </message>
    <message>
        <source>Half modified sine</source>
        <translation>半修正正弦</translation>
    </message>
    <message>
        <source>Acceleration is zero at both ends and peaks at only 1.57 times its mean.</source>
        <translation>两端加速度为零，峰值仅为平均值的 1.57 倍。</translation>
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
        <source>Distance from the shaft&apos;s center to the knife edge: half of the diameter measured at the edge. All knife speeds refer to the edge.</source>
        <translation>从轴心到刀刃的距离：在刀刃处测得直径的一半。切刀的所有速度均指刀刃处。</translation>
    </message>
    <message>
        <source>Knives N</source>
        <translation>刀数 N</translation>
    </message>
    <message>
        <source>Number of knives on the shaft, evenly spaced. Each bag turns the shaft by one knife.</source>
        <translation>轴上均匀分布的切刀数。每个袋使轴转过一把刀。</translation>
    </message>
    <message>
        <source>Pulses per motor rev. K</source>
        <translation>电机每转脉冲 K</translation>
    </message>
    <message>
        <source>Pulses per motor revolution, as set in the servo drive&apos;s electronic gear. A wrong value makes all bags too long or too short.</source>
        <translation>电机每转的脉冲数，按伺服驱动器的电子齿轮比设定。数值错误会使所有袋过长或过短。</translation>
    </message>
    <message>
        <source>Gear Z, motor revs</source>
        <translation>传动比 Z，电机转数</translation>
    </message>
    <message>
        <source>Motor revolutions for the knife shaft revolutions below, see the gear&apos;s nameplate: 7 and 3 for a gear of 7:3.</source>
        <translation>对应下方刀轴转数的电机转数，见减速机铭牌：7:3 的减速机填 7 和 3。</translation>
    </message>
    <message>
        <source>Gear Z, knife revs</source>
        <translation>传动比 Z，刀轴转数</translation>
    </message>
    <message>
        <source>Knife shaft revolutions for the motor revolutions above.</source>
        <translation>对应上方电机转数的刀轴转数。</translation>
    </message>
    <message>
        <source>Max. motor speed</source>
        <translation>最高电机转速</translation>
    </message>
    <message>
        <source>Maximum motor speed, see the motor&apos;s nameplate. No recipe exceeds this speed.</source>
        <translation>电机最高转速，见电机铭牌。任何配方都不会超过此转速。</translation>
    </message>
    <message>
        <source>Max. acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Maximum acceleration without vibration or loss of position. Start with a low value, and raise it as the following error allows.</source>
        <translation>不引起振动、不丢失位置的最大加速度。先取小值，跟随误差允许时再提高。</translation>
    </message>
    <message>
        <source>Max. pulse frequency</source>
        <translation>最高脉冲频率</translation>
    </message>
    <message>
        <source>Maximum pulse frequency of the drive&apos;s input, see its manual. The controller has its own limit.</source>
        <translation>驱动器输入的最高脉冲频率，见其手册。控制器另有自身的限值。</translation>
    </message>
    <message>
        <source>Max. rate</source>
        <translation>最高速率</translation>
    </message>
    <message>
        <source>Maximum rate that sealing time and infeed allow, independent of the knife.</source>
        <translation>封口时间和进料允许的最高速率，与切刀能力无关。</translation>
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
        <source>Feed per motor rev.</source>
        <translation>电机每转进给</translation>
    </message>
    <message>
        <source>Travel of the axis per motor revolution, including gear and spindle.</source>
        <translation>电机每转的轴位移，含减速机和丝杠。</translation>
    </message>
    <message>
        <source>Max. motor torque</source>
        <translation>电机最大转矩</translation>
    </message>
    <message>
        <source>Peak torque of the motor, see the motor&apos;s nameplate. 0: unknown, no limit.</source>
        <translation>电机峰值转矩，见电机铭牌。0 表示未知，不限制。</translation>
    </message>
    <message>
        <source>Inertia at the motor</source>
        <translation>折算到电机的惯量</translation>
    </message>
    <message>
        <source>Total inertia of motor, gear and load at the motor. CamPanel uses the inertia to estimate the torque of a motion. 0: unknown.</source>
        <translation>折算到电机的电机、减速机和负载总惯量，用于估算运动所需转矩。0 表示未知。</translation>
    </message>
    <message>
        <source>Friction at the motor</source>
        <translation>折算到电机的摩擦转矩</translation>
    </message>
    <message>
        <source>Friction torque at the motor while the axis turns slowly and steadily.</source>
        <translation>轴缓慢匀速转动时折算到电机的摩擦转矩。</translation>
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
        <source>Contact before</source>
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
        <translation>终点公差</translation>
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
        <source>Jaw contact angle</source>
        <translation>封刀接触角</translation>
    </message>
    <message>
        <source>Angle of the knife shaft over which the sealing jaws touch the film: their arc divided by the knife radius. 0 is a thin knife, without checks of window and seal time.</source>
        <translation>封刀接触薄膜时刀轴转过的角度：封刀弧长除以刀半径。0 表示薄刀，不检查同步区和封口时间。</translation>
    </message>
    <message>
        <source>Min. seal time</source>
        <translation>最短封口时间</translation>
    </message>
    <message>
        <source>Minimum time of the jaws on the film, see the film&apos;s data sheet. The panel limits the rate accordingly. The controller does not store this value. 0: no minimum.</source>
        <translation>封刀接触薄膜的最短时间，见薄膜数据表。面板据此限制速率。控制器不存储该值。0 表示无要求。</translation>
    </message>
    <message>
        <source>Ramps, slow to gentle</source>
        <translation>斜坡位置（低速至平缓）</translation>
    </message>
    <message>
        <source>Rated motor torque</source>
        <translation>电机额定转矩</translation>
    </message>
    <message>
        <source>Continuous torque of the motor, see the motor&apos;s nameplate. The RMS torque of a cycle stays below it. 0: unknown, no limit.</source>
        <translation>电机连续转矩，见电机铭牌。一个周期的均方根转矩不超过该值。0 表示未知，不限制。</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>固有频率</translation>
    </message>
    <message>
        <source>Lowest natural frequency of the shaft behind the motor, from a measurement or the drive&apos;s analysis. 0: unknown.</source>
        <translation>电机后轴系的最低固有频率，由测量或驱动器分析得到。0 表示未知。</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>Damping of this vibration as a share of critical damping. 0.05 is usual for a shaft with gear.</source>
        <translation>该振动的阻尼与临界阻尼之比。带减速机的轴通常为 0.05。</translation>
    </message>
    <message>
        <source>knife speed</source>
        <translation>刀速</translation>
    </message>
    <message>
        <source>knife stroke</source>
        <translation>切刀行程</translation>
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
        <source>max. rate</source>
        <translation>最高速率</translation>
    </message>
    <message>
        <source>table rows</source>
        <translation>数据表行数</translation>
    </message>
    <message>
        <source>motor torque</source>
        <translation>电机转矩</translation>
    </message>
    <message>
        <source>sync window</source>
        <translation>同步区</translation>
    </message>
    <message>
        <source>seal time</source>
        <translation>封口时间</translation>
    </message>
    <message>
        <source>RMS torque</source>
        <translation>均方根转矩</translation>
    </message>
    <message>
        <source>natural frequency</source>
        <translation>固有频率</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>休止</translation>
    </message>
    <message>
        <source>Constant speed</source>
        <translation>匀速</translation>
    </message>
    <message>
        <source>Polynomial 3, with speeds</source>
        <translation>三次多项式，可设速度</translation>
    </message>
    <message>
        <source>Polynomial 5, with speeds and accelerations</source>
        <translation>五次多项式，可设速度和加速度</translation>
    </message>
    <message>
        <source>As a speed law, acceleration is zero at both ends and peaks at only 1.5 times its mean.</source>
        <translation>用作速度规律时，两端加速度为零，峰值仅为平均值的 1.5 倍。</translation>
    </message>
    <message>
        <source>Jerk jumps at both ends; a trapezoid with ramps above 22.29 % of the move needs less peak acceleration.</source>
        <translation>跃度在两端突变；斜坡超过行程时间 22.29 % 的梯形规律所需的峰值加速度更低。</translation>
    </message>
    <message>
        <source>Low peak speed (1.76), moderate peak acceleration (5.53) and continuous acceleration suit large inertia.</source>
        <translation>峰值速度低（1.76），峰值加速度适中（5.53），加速度无突变，适合大惯量负载。</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps at both ends and in the middle, and peak speed (2) is high.</source>
        <translation>用作位移规律时，加速度在两端和中点突变，峰值速度（2）较高。</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps at both ends of both ramps, so jerk is unbounded.</source>
        <translation>用作位移规律时，加速度在两段斜坡的两端突变，跃度无界。</translation>
    </message>
    <message>
        <source>Jerk jumps at every joint of the segments; a smaller jerk share means a higher jerk.</source>
        <translation>跃度在各段衔接处突变；跃度比例越小，跃度越大。</translation>
    </message>
    <message>
        <source>The law is not symmetric: from rest, the travel is 0.568 of end speed times time; jerk jumps at both ends.</source>
        <translation>规律不对称：从静止起步的行程为终了速度与时间乘积的 0.568 倍；跃度在两端突变。</translation>
    </message>
</context>
<context>
    <name>RecipeComparison</name>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Program type</source>
        <translation>程序类型</translation>
    </message>
    <message>
        <source>Pinned values</source>
        <translation>固定输入</translation>
    </message>
    <message>
        <source>Law parameter 1</source>
        <translation>规律参数 1</translation>
    </message>
    <message>
        <source>Law parameter 2</source>
        <translation>规律参数 2</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>条码</translation>
    </message>
    <message>
        <source>Film reel</source>
        <translation>膜卷</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Confirmed advance</source>
        <translation>已确认的净进给</translation>
    </message>
    <message>
        <source>%1 per cycle</source>
        <translation>每周期 %1</translation>
    </message>
    <message>
        <source>Trim: %1</source>
        <translation>微调：%1</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <comment>name of a value</comment>
        <translation>批准范围：%1</translation>
    </message>
</context>
<context>
    <name>RecipeWords</name>
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
        <source>%1 segments</source>
        <translation>%1 个运动段</translation>
    </message>
    <message>
        <source>1 segment</source>
        <translation>1 个运动段</translation>
    </message>
    <message>
        <source>%1 knots</source>
        <translation>%1 个型值点</translation>
    </message>
    <message>
        <source>Bag %1</source>
        <comment>name of a recipe, length in mm</comment>
        <translation>袋 %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>计数</translation>
    </message>
</context>
<context>
    <name>RefusalSentences</name>
    <message>
        <source>%1 %2</source>
        <comment>%1: name of a field, %2: value with unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Within all limits.</source>
        <translation>在所有限值之内。</translation>
    </message>
    <message>
        <source>Within all limits. Possible up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>在所有限值之内。最快可达 %1（受限于%2）。</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>刚好在限值之内。</translation>
    </message>
    <message>
        <source>Just within the limits. Possible up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>刚好在限值之内。最快可达 %1（受限于%2）。</translation>
    </message>
    <message>
        <source>Motor speed would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>电机转速在 %3 s（%4°）处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Knife acceleration would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>切刀加速度在 %3 s（%4°）处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Pulse frequency would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>脉冲频率在 %3 s（%4°）处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>%1 is required; the machine&apos;s limit is %2.</source>
        <translation>需要 %1，机器的限值为 %2。</translation>
    </message>
    <message>
        <source>%1 has no value. Enter %2 to %3.</source>
        <translation>%1没有值。请输入 %2 到 %3。</translation>
    </message>
    <message>
        <source>%1 would be %2; the allowed range is %3 to %4.</source>
        <translation>%1将为 %2，允许范围为 %3 到 %4。</translation>
    </message>
    <message>
        <source>Pin two of bag length, rate, base speed and film speed.</source>
        <translation>请固定袋长、速率、基本速度和膜速中的两个。</translation>
    </message>
    <message>
        <source>This speed law is unknown. Choose another law.</source>
        <translation>无法识别此速度规律。请选择其他规律。</translation>
    </message>
    <message>
        <source>%1 is %2; the nearest possible value is %3.</source>
        <translation>%1为 %2，最接近的允许值为 %3。</translation>
    </message>
    <message>
        <source>The ratios must descend from k1 to k4: %1 is %2 and must be below %3.</source>
        <translation>比例必须从 k1 到 k4 递减：%1为 %2，必须小于 %3。</translation>
    </message>
    <message>
        <source>A bag of %1 exceeds the knife stroke; with these ratios the maximum is %2.</source>
        <translation>%1 的袋长超过切刀行程，按当前比例最长为 %2。</translation>
    </message>
    <message>
        <source>The table needs %1 rows, the controller has %2. Use fewer slices per ramp.</source>
        <translation>数据表需要 %1 行，控制器只有 %2 行。请减少斜坡分段数。</translation>
    </message>
    <message>
        <source>A cycle has only %1 pulses. Check pulses per revolution, gear and knives.</source>
        <translation>一个周期只有 %1 个脉冲。请检查每转脉冲、传动比和刀数。</translation>
    </message>
    <message>
        <source>Motor speed would reach %1 at %3 s; the limit is %2.</source>
        <translation>电机转速在 %3 s 处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Acceleration would reach %1 at %3 s; the limit is %2.</source>
        <translation>加速度在 %3 s 处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Motor torque would reach %1 at %3 s; the limit is %2.</source>
        <translation>电机转矩在 %3 s 处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Following the master would require %1 at %3 s; the limit is %2.</source>
        <translation>跟随主轴在 %3 s 处需要 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Pulse frequency would reach %1 at %3 s; the limit is %2.</source>
        <translation>脉冲频率在 %3 s 处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>The cam has %1 knots; the nearest possible number is %2.</source>
        <translation>凸轮有 %1 个型值点，最接近的允许数目为 %2。</translation>
    </message>
    <message>
        <source>Knot %1 at %2 must come after the previous knot at %3.</source>
        <translation>型值点 %1（%2）必须位于前一点（%3）之后。</translation>
    </message>
    <message>
        <source>Knot %1 is only %2 after the previous knot; the minimum is %3.</source>
        <translation>型值点 %1 距前一点仅 %2，最小为 %3。</translation>
    </message>
    <message>
        <source>Knot %1 at %2 is out of range; the nearest position is %3.</source>
        <translation>型值点 %1（%2）超出范围，最近的允许位置为 %3。</translation>
    </message>
    <message>
        <source>Knot %1 is at %2; the cam needs a knot at %3.</source>
        <translation>型值点 %1 位于 %2，但凸轮在 %3 处需要一个型值点。</translation>
    </message>
    <message>
        <source>Near knot %1 the curve reaches %2, beyond the end of the knots&apos; range at %3. Move the knot or add another knot.</source>
        <translation>在型值点 %1 附近曲线达到 %2，超出型值点范围的终点 %3。请移动该点或增加一点。</translation>
    </message>
    <message>
        <source>Speed jumps by %1 at the end of the cycle. Choose periodic ends.</source>
        <translation>周期衔接处速度突变 %1。请选择周期端点。</translation>
    </message>
    <message>
        <source>%1 is %2, which gives no motion. Enter another value.</source>
        <translation>%1为 %2：不会产生运动。请输入其他值。</translation>
    </message>
    <message>
        <source>These speeds require at least %1, not %2.</source>
        <translation>这些速度至少需要 %1，而不是 %2。</translation>
    </message>
    <message>
        <source>The distance %1 and the speeds have opposite directions. Change the sign of the distance.</source>
        <translation>距离 %1 与速度方向相反。请改变距离的符号。</translation>
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
        <source>The table exceeds the controller&apos;s range. Use fewer pulses per revolution or a shorter motion.</source>
        <translation>数据表超出控制器的范围。请减少每转脉冲数或缩短运动。</translation>
    </message>
    <message>
        <source>%1 needs a ramp of %2 ms at maximum acceleration; the controller allows %3 ms. Enter a lower speed or a higher acceleration.</source>
        <translation>%1以最大加速度需要 %2 ms 的斜坡，控制器最多允许 %3 ms。请输入更低的速度或更大的加速度。</translation>
    </message>
    <message>
        <source>The motion reverses, but intervals run in one direction. Choose cam points.</source>
        <translation>运动会反向，而区间只能单向。请选择凸轮点。</translation>
    </message>
    <message>
        <source>With whole pulses, a speed error of %1 is not possible, but %2 is. Use more pulses per revolution.</source>
        <translation>按整数脉冲无法达到 %1 的速度误差，但可以达到 %2。请增加每转脉冲数。</translation>
    </message>
    <message>
        <source>The motion has too few pulses for intervals. Use more pulses per revolution.</source>
        <translation>该运动的脉冲太少，不能使用区间。请增加每转脉冲数。</translation>
    </message>
    <message>
        <source>Acceleration would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>加速度在 %3 s（%4°）处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Motor torque would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>电机转矩在 %3 s（%4°）处将达到 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>Following the master would require %1 at %3 s (%4°); the limit is %2.</source>
        <translation>跟随主轴在 %3 s（%4°）处需要 %1，限值为 %2。</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1，或%2</translation>
    </message>
    <message>
        <source>%1 Nearest possible value: %2.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1最近的可行值：%2。</translation>
    </message>
    <message>
        <source>Widen the window, %1</source>
        <comment>%1: rate with unit</comment>
        <translation>加宽同步区，%1</translation>
    </message>
    <message>
        <source>Widen the window</source>
        <translation>加宽同步区</translation>
    </message>
    <message>
        <source>Ratios %1</source>
        <translation>比例 %1</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <comment>%1: ratios, %2: rate</comment>
        <translation>%1，同时 %2</translation>
    </message>
    <message>
        <source>The jaws need a sync window of %2° of the knife; at %3 s (%4°) the window has only %1°.</source>
        <translation>封刀需要 %2° 的同步区（刀轴角）；在 %3 s（%4°）处只有 %1°。</translation>
    </message>
    <message>
        <source>Seal time would be %1 at %3 s (%4°); the film needs %2.</source>
        <translation>在 %3 s（%4°）处封口时间将为 %1；薄膜需要 %2。</translation>
    </message>
    <message>
        <source>The film needs a seal time of %1, but the machine has no contact angle of the jaws. Enter the angle in Settings, Machine.</source>
        <translation>薄膜需要 %1 的封口时间，但机器没有封刀接触角。请在“设置”的“机器”中输入该角度。</translation>
    </message>
    <message>
        <source>Longer ramps</source>
        <translation>加长斜坡</translation>
    </message>
    <message>
        <source>Shorter ramps</source>
        <translation>缩短斜坡</translation>
    </message>
    <message>
        <source>%1 %2 allow %3.</source>
        <comment>%1: whole sentence, %2: longer ramps, %3: rate with unit</comment>
        <translation>%1%2可达到 %3。</translation>
    </message>
    <message>
        <source>RMS torque would be %1, and the motor would overheat; its rated torque is %2.</source>
        <translation>均方根转矩将为 %1，电机会过热；额定转矩为 %2。</translation>
    </message>
    <message>
        <source>The cycle repeats at %1, above the shaft&apos;s natural frequency of %2. Enter a lower rate, or correct the machine data.</source>
        <translation>循环频率为 %1，高于轴的固有频率 %2。请降低速率，或更正机器数据。</translation>
    </message>
    <message>
        <source>This motion allows up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>此运动最高允许 %1（%2）。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>number, number with unit</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1 %2, approved %3</source>
        <comment>name, value, window</comment>
        <translation>%1 %2，批准范围 %3</translation>
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
        <source>Inputs and outputs</source>
        <translation>输入与输出</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>数据交换</translation>
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
        <source>Read only: the panel writes this register with every status request.</source>
        <translation>只读：面板每次请求状态时写入此寄存器。</translation>
    </message>
    <message>
        <source>Read only: the command keys write this register, each command once and with its own counter.</source>
        <translation>只读：由各命令按键写入，每个命令只发一次，并带有自己的计数。</translation>
    </message>
    <message>
        <source>Read only: written by downloads.</source>
        <translation>只读：由下载写入。</translation>
    </message>
    <message>
        <source>Read only: the panel uses this register to read other registers.</source>
        <translation>只读：面板用此寄存器读取其他寄存器。</translation>
    </message>
    <message>
        <source>Read only: changed by a program download.</source>
        <translation>只读：由程序下载更改。</translation>
    </message>
    <message>
        <source>Read only: set by the panel after connecting.</source>
        <translation>只读：连接后由面板设置。</translation>
    </message>
    <message>
        <source>Read only: only the controller writes this register.</source>
        <translation>只读：只有控制器写入此寄存器。</translation>
    </message>
    <message>
        <source>%1 cannot be %2; the allowed range is %3 to %4. Enter another value.</source>
        <comment>%1: register</comment>
        <translation>%1 不能为 %2；允许范围为 %3 到 %4。请输入其他值。</translation>
    </message>
</context>
<context>
    <name>RunSentences</name>
    <message>
        <source>Reading the program of the controller …</source>
        <translation>正在读取控制器中的程序…</translation>
    </message>
    <message>
        <source>The controller has lost its program: the program was not saved before the restart. Download again.</source>
        <translation>控制器丢失了程序：重启前未保存。请重新下载。</translation>
    </message>
    <message>
        <source>The controller has no program yet. Download one on the Motion page.</source>
        <translation>控制器中还没有程序。请在“运动”页面下载。</translation>
    </message>
    <message>
        <source>No connection. New bags are not shown.</source>
        <translation>无连接。新袋不会显示。</translation>
    </message>
    <message>
        <source>Searching for marks: the bags are scrap</source>
        <translation>正在寻找色标：袋为废袋</translation>
    </message>
    <message>
        <source>Aligning with the marks: the bags are scrap</source>
        <translation>正在对准色标：袋为废袋</translation>
    </message>
    <message>
        <source>Running; first bag not measured yet</source>
        <translation>正在运行；尚未测得第一袋</translation>
    </message>
    <message>
        <source>No bag measured yet. Press Start.</source>
        <translation>尚未测得袋长。请按“启动”。</translation>
    </message>
    <message>
        <source>No bag measured yet.</source>
        <translation>尚未测得袋长。</translation>
    </message>
    <message>
        <source>Mark tracking off</source>
        <translation>色标跟踪关闭</translation>
    </message>
    <message>
        <source>Marks not searched for yet</source>
        <translation>尚未寻找色标</translation>
    </message>
    <message>
        <source>Searching for marks</source>
        <translation>正在寻找色标</translation>
    </message>
    <message>
        <source>No marks found</source>
        <translation>未找到色标</translation>
    </message>
    <message>
        <source>Tracking marks</source>
        <translation>正在跟踪色标</translation>
    </message>
    <message>
        <source>Changing to the new program</source>
        <translation>正在改为新程序</translation>
    </message>
    <message>
        <source>Film waits for a product</source>
        <translation>薄膜等待产品</translation>
    </message>
    <message>
        <source>Knife stays open: product in its path</source>
        <translation>切刀保持张开：产品挡住切刀</translation>
    </message>
    <message>
        <source>No stroke yet. Press Start.</source>
        <translation>尚无行程。请按“启动”。</translation>
    </message>
    <message>
        <source>No stroke yet.</source>
        <translation>尚无行程。</translation>
    </message>
    <message>
        <source>Aligning cuts with marks</source>
        <translation>正在将切断对准色标</translation>
    </message>
    <message>
        <source>Cuts not aligned with marks yet</source>
        <translation>切断尚未对准色标</translation>
    </message>
    <message>
        <source>No bag measured yet. Hold Start.</source>
        <translation>尚未测得袋长。请按住“启动”。</translation>
    </message>
    <message>
        <source>No stroke yet. Hold Start.</source>
        <translation>尚无行程。请按住“启动”。</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Hold Start, or choose other curves with Curves.</source>
        <translation>这些曲线尚无数据。请按住“启动”，或通过“曲线”选择其他曲线。</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Press Start, or choose other curves with Curves.</source>
        <translation>这些曲线尚无数据。请按“启动”，或通过“曲线”选择其他曲线。</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Choose other curves with Curves.</source>
        <translation>这些曲线尚无数据。请通过“曲线”选择其他曲线。</translation>
    </message>
    <message>
        <source>Downloaded. The machine is running this recipe.</source>
        <translation>已下载。机器正按此配方运行。</translation>
    </message>
    <message>
        <source>Downloaded. Hold Start to run this recipe.</source>
        <translation>已下载。按住“启动”运行此配方。</translation>
    </message>
    <message>
        <source>Downloaded. Press Start to run this recipe.</source>
        <translation>已下载。按“启动”运行此配方。</translation>
    </message>
    <message>
        <source>Downloaded. The controller has this recipe.</source>
        <translation>已下载。控制器中已有此配方。</translation>
    </message>
    <message>
        <source>Threading up: no bags before a mark is at the knife</source>
        <translation>穿膜中：色标到达切刀前不制袋</translation>
    </message>
    <message>
        <source>Knife stays open while the film is threaded up</source>
        <translation>穿膜期间切刀保持打开</translation>
    </message>
</context>
<context>
    <name>SegmentSentences</name>
    <message>
        <source>Segment %1 begins at %2, which is out of range; the nearest possible value is %3.</source>
        <translation>第 %1 段起点 %2 超出范围；最接近的可用值为 %3。</translation>
    </message>
    <message>
        <source>Segment %1 has a boundary speed of %2; the nearest possible value is %3.</source>
        <translation>第 %1 段的边界速度为 %2；最接近的可用值为 %3。</translation>
    </message>
    <message>
        <source>Segment %1 has a boundary acceleration of %2; the nearest possible value is %3.</source>
        <translation>第 %1 段的边界加速度为 %2；最接近的可用值为 %3。</translation>
    </message>
    <message>
        <source>Segment %1 ends at %2, which is out of range; the nearest possible value is %3.</source>
        <translation>第 %1 段终点 %2 超出范围；最接近的可用值为 %3。</translation>
    </message>
    <message>
        <source>The cam has %1 segments; the nearest possible number is %2.</source>
        <translation>凸轮有 %1 段；最接近的可用段数为 %2。</translation>
    </message>
    <message>
        <source>Segment %1 is only %2 wide; the minimum is %3.</source>
        <translation>第 %1 段宽度仅 %2；最小为 %3。</translation>
    </message>
    <message>
        <source>Segment %1 begins at %2 and overlaps the segment before it, which ends at %3. Begin it at %3.</source>
        <translation>第 %1 段起点为 %2，与前一段重叠，前一段终点为 %3。请将起点设为 %3。</translation>
    </message>
    <message>
        <source>Segment %1 begins at %2 and leaves a gap: the segment before it ends at %3. Begin it at %3.</source>
        <translation>第 %1 段起点为 %2，留有间隙：前一段终点为 %3。请将起点设为 %3。</translation>
    </message>
    <message>
        <source>The first segment begins at %1; the cycle begins at %2.</source>
        <translation>第一段起点为 %1；周期起点为 %2。</translation>
    </message>
    <message>
        <source>The last segment ends at %1; the cycle ends at %2.</source>
        <translation>最后一段终点为 %1；周期终点为 %2。</translation>
    </message>
    <message>
        <source>The motion of segment %1 is unknown. Choose another motion.</source>
        <translation>第 %1 段的运动规律未知。请选择其他运动规律。</translation>
    </message>
    <message>
        <source>Segment %1: %2 is %3; the nearest possible value is %4.</source>
        <translation>第 %1 段：%2 为 %3；最接近的可用值为 %4。</translation>
    </message>
    <message>
        <source>Speed jumps by %1 at the end of the cycle; the axis can follow %2. Make the segments continuous.</source>
        <translation>周期末速度突变 %1；轴可跟随 %2。请使各段连续。</translation>
    </message>
    <message>
        <source>Speed jumps by %1 where segment %2 begins; the axis can follow %3. Make the segments continuous.</source>
        <translation>第 %2 段起点速度突变 %1；轴可跟随 %3。请使各段连续。</translation>
    </message>
    <message>
        <source>Where segment %1 begins: speed jumps by %2, acceleration by %3.</source>
        <translation>第 %1 段起点：速度突变 %2，加速度突变 %3。</translation>
    </message>
    <message>
        <source>The segments are continuous.</source>
        <translation>各段连续。</translation>
    </message>
    <message>
        <source>At the end of the cycle: speed jumps by %1, acceleration by %2.</source>
        <translation>周期衔接处：速度突变 %1，加速度突变 %2。</translation>
    </message>
</context>
<context>
    <name>StopWords</name>
    <message>
        <source>Waiting for products</source>
        <translation>等待产品</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Film change</source>
        <translation>换膜卷</translation>
    </message>
    <message>
        <source>Film torn</source>
        <translation>膜断裂</translation>
    </message>
    <message>
        <source>No product</source>
        <translation>缺产品</translation>
    </message>
    <message>
        <source>Product jam</source>
        <translation>产品卡料</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>Film jam</source>
        <translation>薄膜卡住</translation>
    </message>
    <message>
        <source>Knife, jaws</source>
        <translation>切刀、封刀</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>调整</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>封口</translation>
    </message>
    <message>
        <source>Bag length</source>
        <translation>袋长</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>印刷</translation>
    </message>
    <message>
        <source>Changeover</source>
        <translation>换产</translation>
    </message>
    <message>
        <source>Cleaning</source>
        <translation>清洁</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Break</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>No order</source>
        <translation>无订单</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>No reason</source>
        <translation>无原因</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>title and code of an alarm</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>group and reason</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>Short stops (up to %1)</source>
        <translation>短停机（%1 以内）</translation>
    </message>
    <message>
        <source>%1 · %2×</source>
        <comment>duration, number of stops</comment>
        <translation>%1 · %2 次</translation>
    </message>
</context>
<context>
    <name>StoreErrorText</name>
    <message>
        <source>the folder cannot be created</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 cannot be opened: %2. Check the disk and its permissions.</source>
        <translation>无法打开面板的数据库 %1：%2。请检查磁盘及其权限。</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 was written by a newer version of CamPanel. Install that version.</source>
        <translation>面板的数据库 %1 由更新版本的 CamPanel 写入。请安装该版本。</translation>
    </message>
    <message>
        <source>The disk is full; data saved before are kept. Free some disk space and save again.</source>
        <translation>磁盘已满；之前保存的数据仍在。请腾出磁盘空间后重新保存。</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is write-protected. Check the disk and its permissions.</source>
        <translation>面板的数据库 %1 被写保护。请检查磁盘及其权限。</translation>
    </message>
    <message>
        <source>The panel&apos;s database did not accept the data: %1.</source>
        <translation>面板的数据库未接受数据：%1。</translation>
    </message>
    <message>
        <source>The records of bags and trends were damaged; new records were started. The damaged file was saved as %1.</source>
        <translation>袋记录和趋势文件已损坏，已重新开始记录。损坏的文件保存为 %1。</translation>
    </message>
    <message>
        <source>this user does not exist</source>
        <translation>没有此用户</translation>
    </message>
    <message>
        <source>at least one user of the level Service must remain</source>
        <translation>必须至少保留一名“维护”级用户</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>this file does not exist</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is damaged. Restart the panel to use the last good copy, if there is one.</source>
        <translation>面板的数据库 %1 已损坏。请重新启动面板：如有最近的完好副本，将使用该副本。</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is in use by another program. Close that program, then restart the panel.</source>
        <translation>面板的数据库 %1 正被另一个程序使用。请关闭该程序，然后重新启动面板。</translation>
    </message>
    <message>
        <source>The users and PINs of this panel are lost; only operators can work. To start without PINs, delete the file %1, restart the panel and restore a backup.</source>
        <translation>此面板的用户及其 PIN 已丢失，只能以操作员权限操作。如不用 PIN 启动，请删除文件 %1，重新启动面板，再恢复备份。</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 was altered by another program: %2 is not of CamPanel. Move the file away, restart the panel and restore a backup.</source>
        <translation>面板的数据库 %1 被其他程序改动过：%2 不属于 CamPanel。请移走该文件，重新启动面板并恢复备份。</translation>
    </message>
    <message>
        <source>The recipe %1 has the last version number and was not saved. Save it under another name.</source>
        <translation>配方 %1 已用完版本号，未保存。请用其他名称保存。</translation>
    </message>
    <message>
        <source>a name has visible characters only, and at least one</source>
        <translation>名称只能含可见字符，且至少一个</translation>
    </message>
    <message>
        <source>The disk with the panel&apos;s data cannot be used: %1. Replace the disk and restore a backup.</source>
        <translation>面板的数据磁盘无法使用：%1。请更换数据磁盘并恢复备份。</translation>
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
        <source>Section</source>
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
        <source>Position %1</source>
        <translation>位置 %1</translation>
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
        <source>Start Hz</source>
        <translation>起始 Hz</translation>
    </message>
    <message>
        <source>End Hz</source>
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
        <source>accel.</source>
        <translation>加速</translation>
    </message>
    <message>
        <source>decel.</source>
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
        <source>Max. speed error: %1 (%2 %) at %3 s</source>
        <translation>最大速度误差：%1（%2 %），在 %3 s</translation>
    </message>
    <message>
        <source>Max. frequency step: %1 Hz at %2 s</source>
        <translation>最大频率阶跃：%1 Hz，在 %2 s</translation>
    </message>
    <message>
        <source>Max. position error: %1 pulses between rows, %2 inside</source>
        <translation>最大位置误差：行间 %1 个脉冲，行内 %2 个脉冲</translation>
    </message>
    <message>
        <source>Drift: none; the pulse remainder is carried over to the next cycle</source>
        <translation>漂移：无；脉冲余数累积到下一周期</translation>
    </message>
    <message>
        <source>%1 points, %2 pulses per cycle, %3 s</source>
        <translation>%1 个点，每周期 %2 个脉冲，%3 s</translation>
    </message>
    <message>
        <source>Max. position error between points: %1 pulses (%2) at %3 s</source>
        <translation>点间最大位置误差：%1 个脉冲（%2），在 %3 s</translation>
    </message>
    <message>
        <source>Max. speed error: %1 at %2 s</source>
        <translation>最大速度误差：%1，在 %2 s</translation>
    </message>
    <message>
        <source>%1 intervals, %2 pulses, %3 s instead of %4 s</source>
        <translation>%1 个区间，%2 个脉冲，%3 s（设定 %4 s）</translation>
    </message>
    <message>
        <source>Max. speed error: %1 at %2 s, position: %3 pulses</source>
        <translation>最大速度误差：%1，在 %2 s；位置：%3 个脉冲</translation>
    </message>
    <message>
        <source>%1 stages; the pulse generator counts the last section, %2 per pulse</source>
        <translation>%1 个阶段；最后一段由脉冲发生器计数，每脉冲 %2</translation>
    </message>
    <message>
        <source>Error of the paper&apos;s rounding rule: %1 pulses (%2) per bag</source>
        <translation>论文取整方法的误差：每袋 %1 个脉冲（%2）</translation>
    </message>
</context>
<context>
    <name>TrimWords</name>
    <message>
        <source>Cut</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>产品</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>提前</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>延后</translation>
    </message>
    <message>
        <source>%1 earlier</source>
        <translation>提前 %1</translation>
    </message>
    <message>
        <source>%1 later</source>
        <translation>延后 %1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后移</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前移</translation>
    </message>
    <message>
        <source>%1 back</source>
        <translation>后移 %1</translation>
    </message>
    <message>
        <source>%1 forward</source>
        <translation>前移 %1</translation>
    </message>
    <message>
        <source>Shorter</source>
        <translation>缩短</translation>
    </message>
    <message>
        <source>Longer</source>
        <translation>加长</translation>
    </message>
    <message>
        <source>%1 shorter</source>
        <translation>缩短 %1</translation>
    </message>
    <message>
        <source>%1 longer</source>
        <translation>加长 %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Access</name>
    <message>
        <source>A name has 1 to %1 characters.</source>
        <translation>名称须为 1 至 %1 个字符。</translation>
    </message>
    <message>
        <source>This name is already in use.</source>
        <translation>此名称已被使用。</translation>
    </message>
    <message>
        <source>There is not enough memory to store a PIN safely. Restart the panel.</source>
        <translation>内存不足，无法安全保存 PIN。请重新启动面板。</translation>
    </message>
    <message>
        <source>%1 can log in now.</source>
        <translation>%1 现在可以登录。</translation>
    </message>
    <message>
        <source>%1 has a new PIN.</source>
        <translation>已为 %1 设定新 PIN。</translation>
    </message>
    <message>
        <source>%1 now has the level %2.</source>
        <translation>%1 现在的级别为%2。</translation>
    </message>
    <message>
        <source>%1 can no longer log in.</source>
        <translation>%1 不能再登录。</translation>
    </message>
    <message>
        <source>At least one user of the level Service must remain.</source>
        <translation>必须至少保留一名“维护”级用户。</translation>
    </message>
    <message>
        <source>The name has characters that nobody can see. Enter the name again.</source>
        <translation>名称含有不可见字符。请重新输入名称。</translation>
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
        <source>This alarm was logged by a newer panel version.</source>
        <translation>此报警由较新版本的面板记录。</translation>
    </message>
    <message>
        <source>still active</source>
        <translation>尚未恢复</translation>
    </message>
    <message>
        <source>unknown: the panel was off or the controller was changed</source>
        <translation>未知：期间面板关机或更换了控制器</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>not required</source>
        <translation>无需确认</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>time, person</comment>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmHistory</name>
    <message>
        <source>alarms</source>
        <translation>报警</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmWatch</name>
    <message>
        <source>Axis: following error %1 pulses, limit %2 pulses</source>
        <translation>轴：跟随误差 %1 脉冲，极限 %2 脉冲</translation>
    </message>
    <message>
        <source>Axis: following error %1 pulses</source>
        <translation>轴：跟随误差 %1 脉冲</translation>
    </message>
    <message>
        <source>Ram: force %1 N, limit %2 N</source>
        <translation>压头：力 %1 N，极限 %2 N</translation>
    </message>
    <message>
        <source>Ram: contact at %1, approach ends at %2</source>
        <translation>压头：在 %1 处接触，趋近止于 %2</translation>
    </message>
    <message>
        <source>Dead time of the mark sensor: entered %1 ms, learned %2 ms, margin ±%3 ms</source>
        <translation>色标传感器的滞后时间：输入 %1 ms，学到 %2 ms，误差 ±%3 ms</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Audit</name>
    <message>
        <source>Checking the audit trail …</source>
        <translation>正在检查审计记录…</translation>
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
        <source>All users</source>
        <translation>所有用户</translation>
    </message>
    <message>
        <source>Row and time</source>
        <translation>行号和时间</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>Requested</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读值</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>哈希</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AxisFields</name>
    <message>
        <source>Main motor: reversed</source>
        <translation>主电机：反向</translation>
    </message>
    <message>
        <source>Film motor: reversed</source>
        <translation>薄膜电机：反向</translation>
    </message>
    <message>
        <source>Infeed motor: reversed</source>
        <translation>进料电机：反向</translation>
    </message>
    <message>
        <source>Film motor: pulses per revolution</source>
        <translation>薄膜电机：每转脉冲数</translation>
    </message>
    <message>
        <source>Film motor: film per revolution</source>
        <translation>薄膜电机：每转薄膜长度</translation>
    </message>
    <message>
        <source>Infeed motor: pulses per product</source>
        <translation>进料电机：每个产品的脉冲数</translation>
    </message>
    <message>
        <source>Film motor: index sensor</source>
        <translation>薄膜电机：零位传感器</translation>
    </message>
    <message>
        <source>Infeed motor: index sensor</source>
        <translation>进料电机：零位传感器</translation>
    </message>
    <message>
        <source>This controller cannot turn a motor the other way. Set the direction at the drive.</source>
        <translation>该控制器不能使电机反向。请在驱动器上设置方向。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AxisMeasurement</name>
    <message>
        <source>No data of the axes. Connect the controller.</source>
        <translation>没有轴数据。请连接控制器。</translation>
    </message>
    <message>
        <source>This controller cannot measure its axes. Update the controller: its register map must be 1.7 or newer.</source>
        <translation>该控制器不能测量轴。请更新控制器：寄存器表须为 1.7 或更新版本。</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1未作任何更改。</translation>
    </message>
    <message>
        <source>Pulses per turn of the main motor</source>
        <translation>主电机每转脉冲数</translation>
    </message>
    <message>
        <source>The measurement was stopped.</source>
        <translation>测量已停止。</translation>
    </message>
    <message>
        <source>The connection was lost during the measurement. The controller stops the axis.</source>
        <translation>测量期间连接中断。控制器会停止该轴。</translation>
    </message>
    <message>
        <source>Length of the last bag by the ruler</source>
        <translation>直尺测得的最后一袋长度</translation>
    </message>
    <message>
        <source>The machine data could not be changed now.</source>
        <translation>现在无法更改机器数据。</translation>
    </message>
    <message>
        <source>%1 instead of %2 is in the machine data now. Download the recipe to use it.</source>
        <translation>机器数据已由 %2 改为 %1。下载配方后生效。</translation>
    </message>
    <message>
        <source>The direction is right. Nothing was changed.</source>
        <translation>方向正确。未作任何更改。</translation>
    </message>
    <message>
        <source>The motor turns the other way now. Measure its direction again, then save.</source>
        <translation>电机现已反向。请再次测量方向，然后保存。</translation>
    </message>
    <message>
        <source>%1 instead of %2 is in the controller now. Save it there.</source>
        <translation>控制器中的值已由 %2 改为 %1。请在控制器中保存。</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>As wired</source>
        <translation>按接线</translation>
    </message>
    <message>
        <source>%1 pulses</source>
        <translation>%1 脉冲</translation>
    </message>
    <message>
        <source>The controller knows no bag yet. Make one bag twice, or let the machine run, then measure the last bag with a ruler.</source>
        <translation>控制器尚无袋的数据。请两次制作单袋，或让机器运行，然后用直尺测量最后一袋。</translation>
    </message>
    <message>
        <source>By the present setting bag %1 is %2 long. Measure it with a ruler and enter its length, %3 to %4: a bag that is farther off is another one.</source>
        <translation>按当前设置，第 %1 袋长 %2。请用直尺测量并输入其长度，%3 至 %4：偏差更大的是另一袋。</translation>
    </message>
    <message>
        <source>Keep hands away: the axis turns slowly by a quarter of a turn, forward. Watch which way.</source>
        <translation>请勿靠近：该轴缓慢向前转四分之一转。请观察方向。</translation>
    </message>
    <message>
        <source>Keep hands away and take the film out of the jaws: the axis turns slowly forward, past five index marks. The controller counts its pulses.</source>
        <translation>请勿靠近，并将薄膜从封切口中取出：该轴缓慢向前转，经过五个零位标记。控制器计数其脉冲。</translation>
    </message>
    <message>
        <source>Keep hands away: the film motor turns slowly forward, past five index marks. The controller counts its pulses.</source>
        <translation>请勿靠近：薄膜电机缓慢向前转，经过五个零位标记。控制器计数其脉冲。</translation>
    </message>
    <message>
        <source>Keep hands away: the infeed moves slowly forward by five products. The controller counts its pulses.</source>
        <translation>请勿靠近：进料缓慢向前送五件产品。控制器计数其脉冲。</translation>
    </message>
    <message>
        <source>The turns differ by %1 pulses, too much. Check the index sensor, then measure again.</source>
        <translation>各转相差 %1 脉冲，过大。请检查零位传感器，然后重新测量。</translation>
    </message>
    <message>
        <source>The measured value is outside the range of the setting. Check the sensor and the bag.</source>
        <translation>测量值超出设置范围。请检查传感器和袋。</translation>
    </message>
    <message>
        <source>The bag is %1 by the ruler and %2 by the setting.</source>
        <translation>该袋按直尺为 %1，按设置为 %2。</translation>
    </message>
    <message>
        <source>Five turns, which differ by %1 pulses.</source>
        <translation>共五转，各转相差 %1 脉冲。</translation>
    </message>
    <message>
        <source>Turning: %1 of %2 turns counted.</source>
        <translation>正在转动：已计 %1 转，共 %2 转。</translation>
    </message>
    <message>
        <source>Turning …</source>
        <translation>正在转动……</translation>
    </message>
    <message>
        <source>Which way did it go?</source>
        <translation>朝哪个方向转？</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>正在写入……</translation>
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
        <source>CamPanel before restore %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel 恢复前 %1</translation>
    </message>
    <message>
        <source>The restore was not started: %1. Nothing was changed.</source>
        <translation>恢复未开始：%1。没有任何更改。</translation>
    </message>
    <message>
        <source>The file is valid: %1.
It replaces recipes, machine data, users with their PINs, alarms, audit trail and settings of this panel; bags and trends stay. The present state is saved as a backup on this panel, then the panel restarts.</source>
        <translation>文件有效：%1。
本面板的配方、机器数据、用户及其 PIN、报警、审计记录和设置将被替换；袋记录和趋势保留。当前状态先备份到本面板，然后面板重新启动。</translation>
    </message>
    <message>
        <source>The file is valid: %1.
It replaces recipes, machine data, users with their PINs, alarms, audit trail, bags, trends and settings of this panel. The present state is saved as a backup on this panel, then the panel restarts.</source>
        <translation>文件有效：%1。
本面板的配方、机器数据、用户及其 PIN、报警、审计记录、袋记录、趋势和设置将被替换。当前状态先备份到本面板，然后面板重新启动。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::BuilderFiles</name>
    <message>
        <source>recipes: %1</source>
        <translation>配方：%1</translation>
    </message>
    <message>
        <source>Not taken from the card: %1. %2</source>
        <comment>file, whole sentence</comment>
        <translation>未从存储卡采用：%1。%2</translation>
    </message>
    <message numerus="yes">
        <source>And %n more; the audit trail has all.</source>
        <translation>
            <numerusform>另有 %n 条；审计记录中有全部内容。</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken from the card: %1.</source>
        <comment>list</comment>
        <translation>已从存储卡采用：%1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CamFiles</name>
    <message>
        <source>A new file %1 will be written.</source>
        <translation>将写入新文件 %1。</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <comment>number of knots or segments, date, place</comment>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>无法使用 · %1 · %2</translation>
    </message>
    <message>
        <source>Line %1: %2 Correct the file; the panel reads it again automatically.</source>
        <comment>%2: whole sentence</comment>
        <translation>第 %1 行：%2请更正文件，面板会自动重新读取。</translation>
    </message>
    <message>
        <source>%1 Correct the file; the panel reads it again automatically.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1请更正文件，面板会自动重新读取。</translation>
    </message>
    <message>
        <source>%1, position %2 to %3, will replace those of the recipe. Undo restores them.</source>
        <comment>%1: number of knots or segments</comment>
        <translation>%1，位置 %2 至 %3，将取代配方中的原有内容。可用“撤销”恢复。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CamSwitches</name>
    <message>
        <source>Cam switch %1: mode</source>
        <translation>凸轮开关 %1：方式</translation>
    </message>
    <message>
        <source>Cam switch %1: on angle</source>
        <translation>凸轮开关 %1：接通角度</translation>
    </message>
    <message>
        <source>Cam switch %1: off angle</source>
        <translation>凸轮开关 %1：断开角度</translation>
    </message>
    <message>
        <source>Cam switch %1: lead time</source>
        <translation>凸轮开关 %1：提前时间</translation>
    </message>
    <message>
        <source>Cam switch %1: on in every n-th cycle</source>
        <translation>凸轮开关 %1：每 n 个周期接通一次</translation>
    </message>
    <message>
        <source>Drive enable</source>
        <translation>驱动器使能</translation>
    </message>
    <message>
        <source>%1: contact</source>
        <translation>%1：触点</translation>
    </message>
    <message>
        <source>%1: filter time</source>
        <translation>%1：滤波时间</translation>
    </message>
    <message>
        <source>Cam switch %1</source>
        <translation>凸轮开关 %1</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Date coder pulse: film to the cut</source>
        <translation>打码机脉冲：到切断处的膜长</translation>
    </message>
    <message>
        <source>Date coder pulse: length</source>
        <translation>打码机脉冲：时长</translation>
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
        <translation>限值</translation>
    </message>
    <message>
        <source>Peaks</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>数据表</translation>
    </message>
    <message>
        <source>There is no table: the recipe cannot be downloaded.</source>
        <translation>没有数据表：该配方无法下载。</translation>
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
        <source>The active program was not read back for this report.</source>
        <translation>本报告未回读运行中的程序。</translation>
    </message>
    <message>
        <source>Last bags</source>
        <translation>最近的袋</translation>
    </message>
    <message>
        <source>No bag has been measured yet.</source>
        <translation>尚未测得袋长。</translation>
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
        <source>Standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Within ±%1</source>
        <translation>±%1 以内</translation>
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
        <source>Velocity, %1</source>
        <translation>速度，%1</translation>
    </message>
    <message>
        <source>Acceleration, %1</source>
        <translation>加速度，%1</translation>
    </message>
    <message>
        <source>Pulse frequency, kHz</source>
        <translation>脉冲频率，kHz</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Code of the recipe</source>
        <translation>配方条码</translation>
    </message>
    <message>
        <source>Code of the film reel</source>
        <translation>膜卷条码</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <comment>recipe</comment>
        <translation>%1，未保存</translation>
    </message>
    <message>
        <source>Machine with controller %1</source>
        <comment>serial number</comment>
        <translation>控制器为 %1 的机器</translation>
    </message>
    <message>
        <source>Machine with an unknown controller</source>
        <translation>控制器未知的机器</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Name and signature</source>
        <translation>姓名及签字</translation>
    </message>
    <message>
        <source>The controller follows its clock.</source>
        <translation>控制器跟随自己的时钟。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Controller</name>
    <message>
        <source>Unknown state</source>
        <translation>状态未知</translation>
    </message>
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
        <source>Connection restored. The controller has restarted meanwhile.</source>
        <translation>连接已恢复。期间控制器曾重新启动。</translation>
    </message>
    <message>
        <source>Connection restored. The controller has a different program now.</source>
        <translation>连接已恢复。控制器的程序已更换。</translation>
    </message>
    <message>
        <source>Connection restored. Before: %1. Now: %2.</source>
        <comment>states of the machine</comment>
        <translation>连接已恢复。之前：%1。现在：%2。</translation>
    </message>
    <message>
        <source>Connection restored: Stop was sent, and the controller accepted the command.</source>
        <translation>连接已恢复：停止命令已发送，控制器已接受。</translation>
    </message>
    <message>
        <source>Stop was withdrawn and will not be sent.</source>
        <translation>停止命令已撤回，不会再发送。</translation>
    </message>
    <message>
        <source>Stop was not sent: a different machine is connected now.</source>
        <translation>停止命令未发送：现在连接的是另一台机器。</translation>
    </message>
    <message>
        <source>Connection restored: Stop was sent, but the machine was no longer running.</source>
        <translation>连接已恢复：停止命令已发送，但机器已不在运行。</translation>
    </message>
    <message>
        <source>Stop was sent. Waiting for the response.</source>
        <translation>停止命令已发送，正在等待应答。</translation>
    </message>
    <message>
        <source>Stop is not sent yet. The panel sends Stop as soon as the connection is restored.</source>
        <translation>停止命令尚未发送。连接恢复后立即发送。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CutterMap</name>
    <message>
        <source>Lmin: the jaws just fill the window</source>
        <translation>Lmin：封刀刚好占满窗口</translation>
    </message>
    <message>
        <source>h/c: the knife turns evenly</source>
        <translation>h/c：切刀匀速转动</translation>
    </message>
    <message>
        <source>Lcrit: the longest ramps stop the knife</source>
        <translation>Lcrit：最长斜坡使切刀停顿</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>%1: bag length, %2: rate</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Up to %1; limited by: %2.</source>
        <comment>%1: rate, %2: name of the limit</comment>
        <translation>最快 %1，受限于%2。</translation>
    </message>
    <message>
        <source>No rate is possible; limited by: %1.</source>
        <comment>name of the limit</comment>
        <translation>任何速率都不可行，受限于%1。</translation>
    </message>
    <message>
        <source>Line up to %1; limited by: %2. This program: %3; the run ends above %4.</source>
        <comment>%1, %3, %4: speeds, %2: name of the limit</comment>
        <translation>线速最高 %1，受限于%2。本程序：%3；超过 %4 时运行结束。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::DatabaseService</name>
    <message>
        <source>%1 Until then, new data are lost at a restart.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1在此之前，新数据在重启后丢失。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged. The last good copy is used; the damaged file is kept as %1.</source>
        <translation>面板的数据库曾损坏，现使用最近的完好副本；损坏的文件保留为 %1。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged and there was no copy. A new, empty database was created; the damaged file is kept as %1.</source>
        <translation>面板的数据库已损坏且没有副本，已新建空数据库；损坏的文件保留为 %1。</translation>
    </message>
    <message>
        <source>The backup has been restored. The previous data are kept in %1.</source>
        <translation>备份已恢复。之前的内容保存在 %1。</translation>
    </message>
    <message>
        <source>The restore could not be completed: %1. The panel tries again at the next start.</source>
        <translation>恢复未能完成：%1。下次启动时将再次尝试。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was missing or empty and was replaced by the last good copy. Data saved after the last start are lost.</source>
        <translation>面板的数据库丢失或为空，已用最近的完好副本代替。上次启动之后保存的数据已丢失。</translation>
    </message>
    <message>
        <source>The panel&apos;s database was missing or empty, and there was no good copy. A new, empty database was created; restore a backup.</source>
        <translation>面板的数据库丢失或为空，且没有完好的副本。已新建空数据库；请恢复备份。</translation>
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
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
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
        <source>Knife speed / film speed</source>
        <translation>刀速与膜速之比</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Sync window</source>
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
    <message>
        <source>The unsaved edits were lost: their file is damaged. The saved recipe is open.</source>
        <translation>未保存的修改已丢失：其文件已损坏。已打开保存的配方。</translation>
    </message>
    <message>
        <source>Restored the stored recipe %1. Undo brings the edits back.</source>
        <translation>已恢复存储的配方 %1。“撤销”可找回修改。</translation>
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
        <source>Bags per minute at the present master speed. This value is calculated, not counted.</source>
        <translation>主轴当前速度下每分钟的袋数。此值为计算值，不是计数值。</translation>
    </message>
    <message>
        <source>rate of the program × master speed</source>
        <translation>程序速率 × 主轴速度</translation>
    </message>
    <message>
        <source>Mean bag length</source>
        <translation>平均袋长</translation>
    </message>
    <message>
        <source>Mean of the last bags (%1, at most 60) since the last change of the set length.</source>
        <translation>上次更改设定长度以来最近若干袋（%1 个，最多 60 个）的平均值。</translation>
    </message>
    <message>
        <source>set length + sum of their deviations / bags</source>
        <translation>设定长度 + 偏差之和 / 袋数</translation>
    </message>
    <message>
        <source>Standard deviation of the bag length</source>
        <translation>袋长标准差</translation>
    </message>
    <message>
        <source>About two thirds of the last bags (%1) are closer to the mean than this value.</source>
        <translation>最近若干袋（%1 个）中约三分之二与平均值之差小于此值。</translation>
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
        <source>Number of the last bags (%1) within ±%2. Set the tolerance in Settings, Machine.</source>
        <translation>最近若干袋（%1 个）中在 ±%2 以内的袋数。公差在“设置”的“机器”中设定。</translation>
    </message>
    <message>
        <source>Start-up scrap, bags of a change of program and those at jaws that stood or jammed are left out: %1.</source>
        <translation>不计开机废袋、换程序时的袋以及封切口停住或卡料处的袋：%1。</translation>
    </message>
    <message>
        <source>bags with a deviation within the tolerance</source>
        <translation>偏差在公差内的袋数</translation>
    </message>
    <message>
        <source>Deviation of the last bag</source>
        <translation>最后一袋的偏差</translation>
    </message>
    <message>
        <source>Positive: the bag is too long. With skipped cuts, the set length is the sum of all lengths in the bag.</source>
        <translation>正值表示袋过长。有略过的切断时，设定长度为所含各段长度之和。</translation>
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
        <source>Mark error of the last cut with a mark, measured by the controller. Mark tracking corrects a part of this error with each cut.</source>
        <translation>控制器测得的最近一次有色标的切断的误差。色标跟踪在每次切断时修正其中一部分。</translation>
    </message>
    <message>
        <source>position of the cut − position required by its mark</source>
        <translation>实际切断位置 − 色标要求的位置</translation>
    </message>
    <message>
        <source>Film saved</source>
        <translation>节省的薄膜</translation>
    </message>
    <message>
        <source>Film that was not used because the film waited for missing products. Counted since power-on of the controller.</source>
        <translation>缺产品时薄膜等待所节省的薄膜。自控制器上电起累计。</translation>
    </message>
    <message>
        <source>missing products × bag length at that time</source>
        <translation>缺失的产品数 × 当时的袋长</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>跟随误差</translation>
    </message>
    <message>
        <source>Last reported difference between commanded and actual position of the axis.</source>
        <translation>最近一次报告的轴指令位置与实际位置之差。</translation>
    </message>
    <message>
        <source>error in pulses / pulses per mm</source>
        <translation>误差脉冲数 / 每 mm 脉冲数</translation>
    </message>
    <message>
        <source>Good strokes</source>
        <translation>合格行程数</translation>
    </message>
    <message>
        <source>Number of the last strokes (%1) that ended at the press position with a force of %2 to %3 N.</source>
        <translation>最近若干行程（%1 次）中，在压装位置结束且力为 %2 至 %3 N 的次数。</translation>
    </message>
    <message>
        <source>strokes that the controller evaluated as good</source>
        <translation>控制器判为合格的行程数</translation>
    </message>
    <message>
        <source>Maximum possible rate</source>
        <translation>最高可行速率</translation>
    </message>
    <message>
        <source>Maximum rate with this bag length, law and machine; limited by: %1. Speeds rise with the rate, acceleration with its square.</source>
        <translation>此袋长、运动规律和机器下的最高速率；限制因素：%1。速度与速率成正比，加速度与其平方成正比。</translation>
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
        <source>Peak motor speed</source>
        <translation>电机峰值转速</translation>
    </message>
    <message>
        <source>Motor speed at the maximum knife speed.</source>
        <translation>切刀速度最高处的电机转速。</translation>
    </message>
    <message>
        <source>Peak knife acceleration</source>
        <translation>切刀峰值加速度</translation>
    </message>
    <message>
        <source>Acceleration at the fastest change of the knife speed.</source>
        <translation>切刀速度变化最快处的加速度。</translation>
    </message>
    <message>
        <source>Peak pulse frequency</source>
        <translation>峰值脉冲频率</translation>
    </message>
    <message>
        <source>Output frequency of the controller at the maximum knife speed.</source>
        <translation>切刀速度最高处控制器的输出频率。</translation>
    </message>
    <message>
        <source>Line utilization</source>
        <translation>线路利用率</translation>
    </message>
    <message>
        <source>Time of the frames on the wire at this baud rate, with the silent intervals of the standard, divided by the communication time. At 100 % no master could poll faster; the rest is time spent waiting for controller and adapter.</source>
        <translation>在此波特率下报文（含标准规定的静默时间）占用线路的时间与通信时间之比。100 % 时任何主站都不可能更快；其余为等待控制器和适配器的时间。</translation>
    </message>
    <message>
        <source>time of the frames on the wire / communication time</source>
        <translation>报文占用线路的时间 / 通信时间</translation>
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
        <source>Maximum response time</source>
        <translation>最长应答时间</translation>
    </message>
    <message>
        <source>Time from sending the request to the last byte of the response. This is one single response, perhaps hours ago: the percentages describe normal operation better.</source>
        <translation>从发送请求到收到应答最后一个字节的时间。这只是一次应答，可能在数小时之前：各百分比更能反映平时情况。</translation>
    </message>
    <message>
        <source>maximum since the last reset of the counters</source>
        <translation>计数清零以来的最大值</translation>
    </message>
    <message>
        <source>50 % of responses within</source>
        <translation>50 % 的应答不超过</translation>
    </message>
    <message>
        <source>%1 % of responses within</source>
        <translation>%1 % 的应答不超过</translation>
    </message>
    <message>
        <source>Time from sending the request to the last byte of the response, both frames on the wire included. Counted since the start of the panel or the last reset of the counters.</source>
        <translation>从发送请求到收到应答最后一个字节的时间，含两帧报文占用线路的时间。自面板启动或上次计数清零起统计。</translation>
    </message>
    <message>
        <source>all responses sorted by time: value at %1 % of their number, up to 6.25 % too high, never too low</source>
        <translation>所有应答按时间排序：取总数 %1 % 处的值，最多偏高 6.25 %，不会偏低</translation>
    </message>
    <message>
        <source>time of response %1 of %2</source>
        <translation>%2 个中第 %1 个的时间</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>应答超时</translation>
    </message>
    <message>
        <source>Waiting time for a response, in addition to both frames on the wire. The panel adapts this time to controller and adapter, and doubles it without a response.</source>
        <translation>等待应答的时间，不含两帧报文占用线路的时间。面板按控制器和适配器自动调整，没有应答时加倍。</translation>
    </message>
    <message>
        <source>%1 × the time in which 99 % of the last responses started, from %2 to %3 ms</source>
        <translation>%1 × 最近应答的 99 % 开始所需的时间，限于 %2 至 %3 ms</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Mean of all values recorded in the displayed time (n = %1).</source>
        <translation>所示时段内记录的全部数值（n = %1）的平均值。</translation>
    </message>
    <message>
        <source>sum of the values / n</source>
        <translation>数值之和 / n</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>About two thirds of the values are closer to the mean than this value.</source>
        <translation>约三分之二的数值与平均值之差小于此值。</translation>
    </message>
    <message>
        <source>√(sum of (value − mean)² / (n − 1))</source>
        <translation>√((数值 − 平均值)² 之和 / (n − 1))</translation>
    </message>
    <message>
        <source>Minimum and maximum</source>
        <translation>最小值和最大值</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>lowest, highest</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Minimum and maximum are single values. The curve shows the mean of each column, the pale band its minimum and maximum.</source>
        <translation>均为单个数值。曲线为每一列的平均值，浅色带为该列的最小值到最大值。</translation>
    </message>
    <message>
        <source>minimum … maximum of the n values</source>
        <translation>n 个数值中的最小值 … 最大值</translation>
    </message>
    <message>
        <source>Within the tolerance</source>
        <translation>公差内</translation>
    </message>
    <message>
        <source>Each bag is compared with the tolerance that was valid at its production.</source>
        <translation>每个袋均按其生产时有效的公差判定。</translation>
    </message>
    <message>
        <source>bags with a deviation within the tolerance / n</source>
        <translation>偏差在公差内的袋数 / n</translation>
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
        <source>One column of the curves covers %1. At the cursor the minimum was %2, the maximum %3.</source>
        <translation>曲线每列为 %1。光标处最小值为 %2，最大值为 %3。</translation>
    </message>
    <message>
        <source>sum of the column&apos;s values / number of values</source>
        <translation>该列数值之和 / 个数</translation>
    </message>
    <message>
        <source>%1 of 100 responses took at most this time.</source>
        <translation>每 100 个应答中有 %1 个不超过此时间。</translation>
    </message>
    <message>
        <source>rate × seal time / required seal time, rounded down</source>
        <translation>速率 × 封口时间 / 要求的封口时间，向下取整</translation>
    </message>
    <message>
        <source>Sync window</source>
        <translation>同步区</translation>
    </message>
    <message>
        <source>Angle over which the knife moves at film speed. It must exceed the contact angle of the jaws by 2°.</source>
        <translation>切刀以膜速转过的角度，必须比封刀接触角大 2°。</translation>
    </message>
    <message>
        <source>Seal time</source>
        <translation>封口时间</translation>
    </message>
    <message>
        <source>Time of the jaws on the film at this rate.</source>
        <translation>该速率下封刀接触薄膜的时间。</translation>
    </message>
    <message>
        <source>Time of the jaws on the film at the present rate. The contact angle is that of the recipe on the Motion page.</source>
        <translation>当前速率下封刀接触薄膜的时间。接触角取自“运动”页的配方。</translation>
    </message>
    <message>
        <source>60 000 × arc of the jaws / (sync ratio × bag length × rate)</source>
        <translation>60 000 × 封刀弧长 /（同步比 × 袋长 × 速率）</translation>
    </message>
    <message>
        <source>RMS knife acceleration</source>
        <translation>切刀均方根加速度</translation>
    </message>
    <message>
        <source>Root mean square of the acceleration over a cycle. It heats the motor; I2 is the integral of the squared slope of the law.</source>
        <translation>一个周期内加速度的均方根值，决定电机发热；I2 是规律斜率平方的积分。</translation>
    </message>
    <message>
        <source>Speed ratio k0</source>
        <translation>速度比 k0</translation>
    </message>
    <message>
        <source>Film speed divided by base speed, equation (9) of the paper. It follows from the recipe.</source>
        <translation>膜速与基本速度之比，即论文的式 (9)，由配方得出。</translation>
    </message>
    <message>
        <source>Speed of the base circle ω</source>
        <translation>基圆角速度 ω</translation>
    </message>
    <message>
        <source>Angular speed of the knife at base speed, equation (7) of the paper. Its base circle has the knife radius.</source>
        <translation>基本速度下切刀的角速度，即论文的式 (7)，基圆半径取切刀半径。</translation>
    </message>
    <message>
        <source>Coefficients C0 to C%1</source>
        <translation>系数 C0 至 C%1</translation>
    </message>
    <message>
        <source>The law is the polynomial s = C0 + C1 t + C2 t^2 … of the paper, s in mm and t in ms: %1.</source>
        <translation>该规律是论文中的多项式 s = C0 + C1 t + C2 t^2 …，s 以 mm、t 以 ms 计：%1。</translation>
    </message>
    <message>
        <source>rate × √((allowed − friction) / (peak − friction)), rounded down</source>
        <translation>速率 × √((允许值 − 摩擦) / (峰值 − 摩擦))，向下取整</translation>
    </message>
    <message>
        <source>rate × √((allowed + friction) / (peak + friction)), rounded down</source>
        <translation>速率 × √((允许值 + 摩擦) / (峰值 + 摩擦))，向下取整</translation>
    </message>
    <message>
        <source>rate × ((allowed² − friction²) / (RMS² − friction²))^(1/4), rounded down</source>
        <translation>速率 × ((允许值² − 摩擦²) / (均方根² − 摩擦²))^(1/4)，向下取整</translation>
    </message>
    <message>
        <source>Peak motor torque</source>
        <translation>电机峰值转矩</translation>
    </message>
    <message>
        <source>Maximum torque at the motor. Friction adds to it while the knife speeds up, and helps while the knife slows down.</source>
        <translation>电机的最大转矩。切刀加速时摩擦增大转矩，减速时摩擦有助于制动。</translation>
    </message>
    <message>
        <source>RMS motor torque</source>
        <translation>电机均方根转矩</translation>
    </message>
    <message>
        <source>Root mean square over one cycle. It heats the motor, so it stays below the rated torque.</source>
        <translation>一个周期内的均方根值。它使电机发热，因此须低于额定转矩。</translation>
    </message>
    <message>
        <source>Vibration over the cycle</source>
        <translation>周期内的振动</translation>
    </message>
    <message>
        <source>Vibration after the move</source>
        <translation>运动后的振动</translation>
    </message>
    <message>
        <source>Error of the load behind the shaft, peak to peak over one cycle.</source>
        <translation>轴后负载在一个周期内的误差（峰峰值）。</translation>
    </message>
    <message>
        <source>Amplitude of the load behind the shaft after the end of the move.</source>
        <translation>运动结束后轴后负载的残余振幅。</translation>
    </message>
    <message>
        <source>f0 = %1 Hz, ζ = %2, T = %3 s</source>
        <translation>f0 = %1 Hz，ζ = %2，T = %3 s</translation>
    </message>
    <message>
        <source>f0 = %1 Hz, T = %2 s</source>
        <translation>f0 = %1 Hz，T = %2 s</translation>
    </message>
    <message>
        <source>Error while sealing</source>
        <translation>封切误差</translation>
    </message>
    <message>
        <source>Vibration of the knife shaft, peak to peak, between both ends of the sealing window.</source>
        <translation>切刀轴在封切窗口两端之间振动的峰峰值。</translation>
    </message>
    <message>
        <source>Torque, largest difference</source>
        <translation>转矩最大偏差</translation>
    </message>
    <message>
        <source>torque that the drive reports − (J α + friction), of the rated torque</source>
        <translation>驱动器报告的转矩 − (J α + 摩擦)，占额定转矩</translation>
    </message>
    <message>
        <source>Compared while the machine runs at full speed.</source>
        <translation>机器以全速运行时进行比较。</translation>
    </message>
    <message>
        <source>Largest of the last readings at full speed (%1), at %2° of the cycle. The drive lags behind the program, so the difference is largest where the acceleration changes fast.</source>
        <translation>最近全速读数（%1 个）中的最大值，位于周期的 %2°。驱动器滞后于程序，因此加速度变化快处偏差最大。</translation>
    </message>
    <message>
        <source>Availability</source>
        <translation>时间开动率</translation>
    </message>
    <message>
        <source>Share of the planned time in which the machine ran. Planned time is the recorded time of the shift (%1 min) without planned stops (%2 min).</source>
        <translation>机器运行时间占计划时间的比例。计划时间为班次的记录时间（%1 分）减去计划停机（%2 分）。</translation>
    </message>
    <message>
        <source>run time / planned time</source>
        <translation>运行时间 / 计划时间</translation>
    </message>
    <message>
        <source>%1 min / %2 min</source>
        <translation>%1 分 / %2 分</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>性能开动率</translation>
    </message>
    <message>
        <source>Speed compared with the ideal rate: the fastest rate of each recipe, or the rate in Settings. A piece is a bag, a stroke or a cycle; a skipped cut takes the time of a piece. Waiting of up to %1 s is a loss of performance. At most 100 %.</source>
        <translation>与理想速率相比的速度：各配方的最高速率，或设置中的速率。一件为一袋、一次压装或一个周期；跳过的切断占用一件的时间。不超过 %1 秒的等待计为性能损失。最高 100 %。</translation>
    </message>
    <message>
        <source>sum of pieces × ideal time per piece / run time</source>
        <translation>Σ（件数 × 每件理想时间）/ 运行时间</translation>
    </message>
    <message>
        <source>%1 min for %2 pieces / %3 min</source>
        <translation>%1 分（%2 件）/ %3 分</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>合格品率</translation>
    </message>
    <message>
        <source>Share of good pieces. Not good: %1 out of tolerance, %2 start-up scrap, %3 skipped cuts.</source>
        <translation>合格件的比例。不合格：超差 %1，开机废品 %2，跳过的切断 %3。</translation>
    </message>
    <message>
        <source>good pieces / pieces</source>
        <translation>合格件数 / 件数</translation>
    </message>
    <message>
        <source>Overall equipment effectiveness (OEE)</source>
        <translation>设备综合效率 (OEE)</translation>
    </message>
    <message>
        <source>Good pieces at the ideal rate, as a share of the planned time.</source>
        <translation>按理想速率生产合格件所需时间占计划时间的比例。</translation>
    </message>
    <message>
        <source>availability × performance × quality</source>
        <translation>时间开动率 × 性能开动率 × 合格品率</translation>
    </message>
    <message>
        <source>Distance from the expected mark</source>
        <translation>与预期色标的距离</translation>
    </message>
    <message>
        <source>The distance of the newest edge of the mark sensor from the place where the controller expected the mark. An edge inside the window is taken as the mark, any other is not.</source>
        <translation>色标传感器最新信号与控制器预期色标位置之间的距离。窗口内的信号作为色标采用，窗口外的不采用。</translation>
    </message>
    <message>
        <source>place of the edge − place of the expected mark</source>
        <translation>信号位置 − 预期色标位置</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FileExchange</name>
    <message>
        <source>%1 is read-only. Unlock the stick or choose another location.</source>
        <translation>%1 为只读。请解除 U 盘的写保护，或选择其他位置。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · 只读</translation>
    </message>
    <message>
        <source>Written: %1. You can remove the stick now.</source>
        <translation>已写入：%1。现在可以拔出 U 盘。</translation>
    </message>
    <message>
        <source>%1 Also missing: %2.</source>
        <comment>%1: whole sentences, %2: files</comment>
        <translation>%1 另外缺少：%2。</translation>
    </message>
    <message>
        <source>Written: %1 of %2 files. %3</source>
        <comment>%3: whole sentences</comment>
        <translation>已写入 %1 个文件，共 %2 个。%3</translation>
    </message>
    <message>
        <source>%1 files in %2</source>
        <comment>number, folder</comment>
        <translation>%2 中的 %1 个文件</translation>
    </message>
    <message>
        <source>Some files are not shown</source>
        <translation>部分文件未显示</translation>
    </message>
    <message>
        <source>%1 · no answer</source>
        <translation>%1 · 无响应</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FilmCheck</name>
    <message>
        <source>Wrong film reel: %1 was scanned, the recipe needs %2. Load and scan the right reel.</source>
        <translation>膜卷错误：扫描到 %1，配方需要 %2。请装上正确的膜卷并扫描。</translation>
    </message>
    <message>
        <source>Unknown code %1: no recipe and no film reel has it. Load and scan the film reel %2.</source>
        <translation>未知条码 %1：没有配方或膜卷使用它。请装上膜卷 %2 并扫描。</translation>
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
        <translation>通信报文</translation>
    </message>
</context>
<context>
    <name>campanel::panel::HandSpeed</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>campanel::panel::HandTrims</name>
    <message>
        <source>The line before this machine places the products.</source>
        <translation>产品由前道生产线放置。</translation>
    </message>
    <message>
        <source>The marks set the length.</source>
        <translation>长度由色标决定。</translation>
    </message>
    <message>
        <source>Limit reached: ±%1.</source>
        <translation>已达极限：±%1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Homing</name>
    <message>
        <source>Referenced</source>
        <translation>已回零</translation>
    </message>
    <message>
        <source>Top position known</source>
        <translation>上止点已知</translation>
    </message>
    <message>
        <source>Not referenced</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>Top position not known</source>
        <translation>上止点未知</translation>
    </message>
    <message>
        <source>No reference run required</source>
        <translation>无需回零</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Keep hands away: the knife turns slowly forward to the index mark of its shaft, brakes and returns to 0°. Start begins with the reference run when required.</source>
        <translation>手不要靠近切刀：切刀缓慢正转到刀轴的零位标记，制动后返回 0°。需要时，启动会自动回零。</translation>
    </message>
    <message>
        <source>The axis turns slowly forward to the index mark of its motor, brakes and returns to position 0. Start begins with the reference run when required.</source>
        <translation>轴缓慢正转到电机的零位标记，制动后返回位置 0。需要时，启动会自动回零。</translation>
    </message>
    <message>
        <source>Moves start at the present axis position, so no reference run is required. The reference run turns slowly to the motor&apos;s index mark, which becomes position 0.</source>
        <translation>运动从轴的当前位置开始，因此无需回零。“回零”使轴缓慢转到电机的零位标记，该处即为位置 0。</translation>
    </message>
    <message>
        <source>No motion: the present ram position becomes the top position, the reference of all depths. Jog the ram there first; a wrong top position makes every stroke wrong.</source>
        <translation>不会产生运动：压头的当前位置将设为上止点，即所有深度的基准。请先将压头点动到该位置；上止点不对，每次压装都会出错。</translation>
    </message>
    <message>
        <source>The reference run depends on the program. Download a recipe first.</source>
        <translation>回零方式取决于程序。请先下载配方。</translation>
    </message>
    <message>
        <source>Reference run</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Set as top position</source>
        <translation>设为上止点</translation>
    </message>
    <message>
        <source>Searching for the index mark …</source>
        <translation>正在寻找零位标记…</translation>
    </message>
    <message>
        <source>The last reference run found the index mark.</source>
        <translation>上次回零已找到零位标记。</translation>
    </message>
    <message>
        <source>The ram position was set as top position.</source>
        <translation>压头位置已设为上止点。</translation>
    </message>
    <message>
        <source>The last reference run was stopped before its end.</source>
        <translation>上次回零在完成之前被停止。</translation>
    </message>
    <message>
        <source>The last reference run failed: no index mark within two revolutions, or the axis did not follow. See the alarm.</source>
        <translation>上次回零失败：两转内没有零位标记，或轴没有跟随。请查看报警。</translation>
    </message>
    <message>
        <source>The connection was lost during the reference run: the result is unknown.</source>
        <translation>回零期间连接中断：结果未知。</translation>
    </message>
    <message>
        <source>Keep hands away: the axis turns slowly to 0°, the shorter way. Its encoder keeps the position without power, so no index mark is searched. Start begins with the reference run when required.</source>
        <translation>手不要靠近：轴沿较短方向缓慢转到 0°。其编码器断电后仍保持位置，因此不寻找零位标记。需要时，启动会自动回零。</translation>
    </message>
    <message>
        <source>Turning to 0° …</source>
        <translation>正在转到 0° …</translation>
    </message>
    <message>
        <source>The last reference run ended at 0°.</source>
        <translation>上次回零已停在 0°。</translation>
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
        <source>not found yet</source>
        <translation>尚未找到</translation>
    </message>
    <message>
        <source>found or not required</source>
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
        <source>%1 marks</source>
        <translation>%1 个色标</translation>
    </message>
    <message>
        <source>%1 products placed</source>
        <translation>已放置 %1 个产品</translation>
    </message>
    <message>
        <source>Encoder of the film</source>
        <translation>薄膜编码器</translation>
    </message>
    <message>
        <source>Pulses to the film</source>
        <translation>送往薄膜轴的脉冲</translation>
    </message>
    <message>
        <source>Knife synchronous with film</source>
        <translation>切刀与薄膜同步</translation>
    </message>
    <message>
        <source>Film, sent minus encoder</source>
        <translation>薄膜：发送减编码器</translation>
    </message>
    <message>
        <source>Torque of the axis, of rated</source>
        <translation>轴转矩，占额定</translation>
    </message>
    <message>
        <source>Encoder of the infeed</source>
        <translation>进料编码器</translation>
    </message>
    <message>
        <source>Infeed, sent minus encoder</source>
        <translation>进料：发出减编码器</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>percent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>axis</source>
        <comment>kept position</comment>
        <translation>轴</translation>
    </message>
    <message>
        <source>film</source>
        <comment>kept position</comment>
        <translation>薄膜</translation>
    </message>
    <message>
        <source>infeed</source>
        <comment>kept position</comment>
        <translation>进料</translation>
    </message>
    <message>
        <source>Positions kept without power</source>
        <translation>断电保持的位置</translation>
    </message>
    <message>
        <source>none</source>
        <comment>kept positions</comment>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>campanel::panel::JamWatch</name>
    <message>
        <source>The controller reports a state that this panel does not know. Update the panel.</source>
        <translation>控制器报告了此面板不认识的状态。请更新面板。</translation>
    </message>
    <message>
        <source>Off. Switch jam detection on in the list of this page.</source>
        <translation>已关闭。请在本页列表中打开卡料检测。</translation>
    </message>
    <message>
        <source>The drive reports no torque: a jam cannot be seen. Connect its torque-limit output to the input Torque limit, which is monitored.</source>
        <translation>驱动器不报告转矩，无法发现卡料。请将驱动器的转矩限制输出接到受监控的“转矩限制”输入。</translation>
    </message>
    <message>
        <source>The drive reports its torque too seldom: a jam cannot be seen. Connect its torque-limit output to the input Torque limit, which is monitored.</source>
        <translation>驱动器报告转矩的频率太低，无法发现卡料。请将驱动器的转矩限制输出接到受监控的“转矩限制”输入。</translation>
    </message>
    <message>
        <source>Learning the torque of this program. Cycles at full speed until armed: %1</source>
        <translation>正在学习此程序的转矩。距开始监控的全速周期数：%1</translation>
    </message>
    <message>
        <source>Armed. Torque beyond the band stops the machine while the jaws close.</source>
        <translation>监控中。封切口闭合期间转矩超出范围时，机器停止。</translation>
    </message>
    <message>
        <source>No jam since power-up.</source>
        <translation>通电以来没有卡料。</translation>
    </message>
    <message>
        <source>%1 behind the cut</source>
        <translation>切断后 %1</translation>
    </message>
    <message>
        <source>%1 before the cut</source>
        <translation>切断前 %1</translation>
    </message>
    <message>
        <source>Torque-limit input on %1. The knife stood after another %2.</source>
        <comment>%1: a place</comment>
        <translation>转矩限制输入接通于%1。切刀又转过 %2 后停住。</translation>
    </message>
    <message>
        <source>Torque %1, %2; the band ends at %3. The knife stood after another %4.</source>
        <comment>%2: a place</comment>
        <translation>转矩 %1，位于%2；范围上限为 %3。切刀又转过 %4 后停住。</translation>
    </message>
    <message>
        <source>%1, for a reason that this panel does not know. Update the panel.</source>
        <comment>%1: a place</comment>
        <translation>%1，原因未知。请更新面板。</translation>
    </message>
    <message>
        <source>Not known before the first 1000 bags.</source>
        <translation>前 1000 个袋子完成之前未知。</translation>
    </message>
    <message>
        <source>%1: mean torque at the cut of 1000 bags, less that of the first 20. It is recorded only; nothing is concluded from it.</source>
        <translation>%1：1000 个袋子切断时的平均转矩减去前 20 个的平均值。仅作记录，不据此得出任何结论。</translation>
    </message>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>没有包装机的数据。请连接控制器并下载旋转切刀的配方。</translation>
    </message>
    <message>
        <source>This controller does not monitor the torque of its knife. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>此控制器不监控切刀的转矩。请更新控制器：寄存器表须为 1.6 或更新版本。</translation>
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
        <source>Stop ended the jog. Release the key before you jog again.</source>
        <translation>点动已被“停止”结束。请先松开按键再点动。</translation>
    </message>
    <message>
        <source>Two keys are pressed: no motion. Release both keys.</source>
        <translation>同时按下了两个键：不会运动。请松开两个键。</translation>
    </message>
    <message>
        <source>Release the key before you jog again.</source>
        <translation>请先松开按键再点动。</translation>
    </message>
    <message>
        <source>No motion: the press does not continue against its force.</source>
        <translation>没有运动：压机受力时不会继续前进。</translation>
    </message>
    <message>
        <source>No motion. Release the key and try again.</source>
        <translation>没有运动。请松开按键后重试。</translation>
    </message>
    <message>
        <source>Moves forward while you hold the key.</source>
        <translation>按住期间正向运动。</translation>
    </message>
    <message>
        <source>Moves in reverse while you hold the key.</source>
        <translation>按住期间反向运动。</translation>
    </message>
    <message>
        <source>Hold a key to turn the knife. The film stays still, and the next start begins with the reference run.</source>
        <translation>按住按键转动切刀。薄膜不动，下次启动会先回零。</translation>
    </message>
    <message>
        <source>Hold a key to move the ram.</source>
        <translation>按住按键移动压头。</translation>
    </message>
    <message>
        <source>Hold a key to move the axis.</source>
        <translation>按住按键移动轴。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::KnotModel</name>
    <message>
        <source>Knot %1, master</source>
        <translation>型值点 %1，主轴</translation>
    </message>
    <message>
        <source>Knot %1, position</source>
        <translation>型值点 %1，位置</translation>
    </message>
    <message>
        <source>The cycle closes smoothly.</source>
        <translation>周期衔接平滑。</translation>
    </message>
    <message>
        <source>At the end of the cycle: speed jumps by %1, acceleration by %2.</source>
        <translation>周期衔接处：速度突变 %1，加速度突变 %2。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LineFigures</name>
    <message>
        <source>Requests</source>
        <translation>请求</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Bytes dropped</source>
        <translation>丢弃的字节</translation>
    </message>
    <message>
        <source>Stray bytes</source>
        <translation>多余字节</translation>
    </message>
    <message>
        <source>Line utilization</source>
        <translation>线路利用率</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>No response</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Wrong checksum</source>
        <translation>校验和错误</translation>
    </message>
    <message>
        <source>Damaged frame</source>
        <translation>报文损坏</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>被控制器拒绝</translation>
    </message>
    <message>
        <source>Port removed</source>
        <translation>端口已移除</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>50 % within</source>
        <translation>50 % 不超过</translation>
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
        <source>Maximum</source>
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
        <source>link statistics</source>
        <translation>通信统计</translation>
    </message>
    <message>
        <source>link 24 hours</source>
        <translation>通信24小时</translation>
    </message>
    <message>
        <source>Foreign response</source>
        <translation>不相干的应答</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>应答超时</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LinkDoctor</name>
    <message>
        <source>A stop command is waiting for the connection and has priority.</source>
        <translation>有一个停止命令在等待连接，停止优先。</translation>
    </message>
    <message>
        <source>A download is in progress. Wait for its end, or cancel the download.</source>
        <translation>正在下载。请等待下载结束，或取消下载。</translation>
    </message>
    <message>
        <source>Trying %1: %2</source>
        <comment>port, settings</comment>
        <translation>正在尝试 %1：%2</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>仿真控制器</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>port, settings</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Diagnose tests the port in use. Search tries all ports, baud rates, parities and unit numbers, which may take long; both only read and interrupt the connection.</source>
        <translation>“诊断”测试使用中的端口。“搜索”尝试所有端口、波特率、校验和站号，可能需要较长时间；两者都只读，期间连接中断。</translation>
    </message>
    <message>
        <source>Searching. The panel reconnects afterwards.</source>
        <translation>正在搜索。结束后恢复连接。</translation>
    </message>
    <message>
        <source>Testing the port in use. The panel reconnects afterwards.</source>
        <translation>正在测试使用中的端口。结束后恢复连接。</translation>
    </message>
    <message>
        <source>A controller responds: %1.</source>
        <translation>有控制器应答：%1。</translation>
    </message>
    <message>
        <source>The connection in use works: %1.</source>
        <translation>使用中的连接正常：%1。</translation>
    </message>
    <message>
        <source>Canceled. The panel reconnects automatically.</source>
        <translation>已取消。面板会自动重新连接。</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug the adapter in and search again.</source>
        <translation>此计算机没有串口。请插入适配器后再搜索。</translation>
    </message>
    <message>
        <source>No controller was found. Result for each port:</source>
        <translation>没有找到控制器。各端口的结果：</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>port, what was found</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LogFilterEditor</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>自 %1 起</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>至 %1</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MarkEdgeList</name>
    <message>
        <source>taken</source>
        <translation>已采用</translation>
    </message>
    <message>
        <source>Taken: %1. The window is ±%2.</source>
        <translation>已采用：%1。窗口为 ±%2。</translation>
    </message>
    <message>
        <source>outside the window</source>
        <translation>窗口之外</translation>
    </message>
    <message>
        <source>Not taken: %1; the window is ±%2. Check film and print, or widen the mark window.</source>
        <translation>未采用：%1；窗口为 ±%2。请检查薄膜和印刷，或加宽色标窗口。</translation>
    </message>
    <message>
        <source>searched</source>
        <translation>搜索中</translation>
    </message>
    <message>
        <source>Searched: the controller looks for two marks at the distance of the recipe&apos;s bag length.</source>
        <translation>搜索中：控制器正在寻找间距等于配方袋长的两个色标。</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>Not used: mark tracking is off. Switch it on in the list of this page.</source>
        <translation>未使用：色标跟踪已关闭。请在本页列表中打开。</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Not taken, for a reason that this panel does not know. Update the panel.</source>
        <translation>未采用，原因是本面板不认识的。请更新面板。</translation>
    </message>
    <message>
        <source>far from the expected mark</source>
        <translation>远离预期色标</translation>
    </message>
    <message>
        <source>%1 before the expected mark</source>
        <translation>在预期色标之前 %1</translation>
    </message>
    <message>
        <source>%1 behind the expected mark</source>
        <translation>在预期色标之后 %1</translation>
    </message>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>没有包装机的数据。请连接控制器并下载旋转切刀的配方。</translation>
    </message>
    <message>
        <source>This controller records no edges of its mark sensor. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>此控制器不记录色标传感器的信号。请更新控制器：寄存器表须为 1.6 或更新版本。</translation>
    </message>
    <message>
        <source>No edges so far. Start the machine: edges are recorded while the film runs.</source>
        <translation>尚无信号。请启动机器：薄膜运行时记录信号。</translation>
    </message>
    <message>
        <source>No edges although the film runs. Check the cable of the mark sensor and that the print passes below the sensor.</source>
        <translation>薄膜在运行，但没有信号。请检查色标传感器的电缆，以及印刷图案是否从传感器下方通过。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>verdict: number of edges</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 edges (%2). Newest edge: %3</source>
        <translation>%1 个信号（%2）。最新信号：%3</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>过窄</translation>
    </message>
    <message>
        <source>Another print: narrower than a mark. If it is one, reduce the minimum width.</source>
        <translation>其他印刷：比色标窄。如果是色标，请减小最小宽度。</translation>
    </message>
    <message>
        <source>too wide</source>
        <translation>过宽</translation>
    </message>
    <message>
        <source>Another print: wider than a mark. If it is one, raise the maximum width.</source>
        <translation>其他印刷：比色标宽。如果是色标，请增大最大宽度。</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>屏蔽</translation>
    </message>
    <message>
        <source>Ignored: it lies in the ignored film behind the mark before it.</source>
        <translation>已屏蔽：位于前一色标后的屏蔽范围内。</translation>
    </message>
    <message>
        <source>%1 Its width is %2.</source>
        <comment>a sentence, a length</comment>
        <translation>%1 宽度为 %2。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MarkWizard</name>
    <message>
        <source>Cut offset behind its mark</source>
        <translation>切断滞后色标的距离</translation>
    </message>
    <message>
        <source>The controller has no program for a packing machine. Download a recipe of a rotary cutter.</source>
        <translation>控制器中没有包装机的程序。请下载旋转切刀的配方。</translation>
    </message>
    <message>
        <source>Mark tracking is off. Switch mark tracking on first.</source>
        <translation>色标跟踪已关闭。请先打开色标跟踪。</translation>
    </message>
    <message>
        <source>Waiting for the cuts to reach the marks …</source>
        <translation>正在等待切断与色标对齐…</translation>
    </message>
    <message>
        <source>Waiting for the controller …</source>
        <translation>正在等待控制器…</translation>
    </message>
    <message>
        <source>The corrected distance is outside the controller&apos;s range. Measure again.</source>
        <translation>修正后的距离超出控制器的范围。请重新测量。</translation>
    </message>
    <message>
        <source>The distance was written, but the cuts of the last bags deviate by %1 from their marks on average. Check gains and film before you measure again.</source>
        <translation>距离已写入，但最近几袋的切断平均偏离色标 %1。重新测量前请检查增益和薄膜。</translation>
    </message>
    <message>
        <source>This bag has been measured already. Wait for the next bag.</source>
        <translation>这一袋已经测量过。请等下一袋。</translation>
    </message>
    <message>
        <source>No bag has been cut yet.</source>
        <translation>还没有切出袋子。</translation>
    </message>
    <message>
        <source>The simulated machine cannot be measured now.</source>
        <translation>现在无法测量仿真机器。</translation>
    </message>
    <message>
        <source>The new distance is active, and the cuts of the last bags are within %1 of the target. Measure one more bag to be sure; without Save, the distance is lost at power-off.</source>
        <translation>新距离已生效，最近几袋的切断与目标位置相差不超过 %1。请再测量一袋确认；不保存则断电后丢失。</translation>
    </message>
    <message>
        <source>When all cuts deviate from their marks by the same distance, the distance from mark sensor to knife is set wrong. The machine cuts a few bags, you measure the cuts from their marks, and the panel corrects the distance after you confirm.</source>
        <translation>如果所有切断都以相同距离偏离色标，说明色标传感器到切刀的距离设定有误。机器切出几袋，您测量切断与色标的距离，经确认后修正设定。</translation>
    </message>
    <message>
        <source>%1 of %2 bags cut. Keep the bags in order and do not stretch them.</source>
        <translation>已切 %1 / %2 袋。请按顺序放好，不要拉伸。</translation>
    </message>
    <message>
        <source>The measurements differ by %1. Check that all of them start at the same edge of the mark.</source>
        <translation>各次测量相差 %1。请检查是否都从色标的同一边量起。</translation>
    </message>
    <message>
        <source>This value becomes the distance from mark sensor to knife. The cuts shift over the next bags.</source>
        <translation>此值将设为色标传感器到切刀的距离。切断位置将在随后几袋中移动。</translation>
    </message>
    <message>
        <source>Writing and reading back …</source>
        <translation>正在写入并回读…</translation>
    </message>
    <message>
        <source>Written and read back. The new distance reaches the knife with bag %1 of at most %2.</source>
        <translation>已写入并回读。新距离随薄膜到达切刀：第 %1 袋，最多 %2 袋。</translation>
    </message>
    <message>
        <source>Measure from the printed mark to the cut: positive if the cut comes after its mark, negative if the cut comes before its mark. The mean of up to %1 bags counts.</source>
        <translation>从印刷色标量到切断处：切断在色标之后为正，在色标之前为负。取最多 %1 袋的平均值。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterDirection</name>
    <message>
        <source>This controller cannot reverse its master. Update its firmware.</source>
        <translation>此控制器不能使主轴换向。请更新其固件。</translation>
    </message>
    <message>
        <source>Waiting for the controller …</source>
        <translation>正在询问控制器…</translation>
    </message>
    <message>
        <source>Changing to reverse …</source>
        <translation>正在换向为反转…</translation>
    </message>
    <message>
        <source>Changing to forward …</source>
        <translation>正在换向为正转…</translation>
    </message>
    <message>
        <source>starts in reverse</source>
        <translation>启动后反转</translation>
    </message>
    <message>
        <source>starts forward</source>
        <translation>启动后正转</translation>
    </message>
    <message>
        <source>set to reverse</source>
        <translation>已设为反转</translation>
    </message>
    <message>
        <source>set to forward</source>
        <translation>已设为正转</translation>
    </message>
    <message>
        <source>runs in reverse</source>
        <translation>正在反转</translation>
    </message>
    <message>
        <source>runs forward</source>
        <translation>正在正转</translation>
    </message>
    <message>
        <source>Master direction</source>
        <translation>主轴方向</translation>
    </message>
    <message>
        <source>The line sets the direction: an encoder leads the machine.</source>
        <translation>方向由生产线决定：编码器为主轴。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterFields</name>
    <message>
        <source>Phase: line ahead of the master</source>
        <translation>相位：生产线超前主轴</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Place of the encoder</source>
        <translation>编码器位置</translation>
    </message>
    <message>
        <source>Signal of the encoder</source>
        <translation>编码器信号</translation>
    </message>
    <message>
        <source>Reversed counting</source>
        <translation>反向计数</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>每转计数</translation>
    </message>
    <message>
        <source>Film per revolution</source>
        <translation>每转薄膜长度</translation>
    </message>
    <message>
        <source>Compensation of the delay</source>
        <translation>延迟补偿</translation>
    </message>
    <message>
        <source>Delay of the drive</source>
        <translation>驱动器延迟</translation>
    </message>
    <message>
        <source>Smoothing: time constant</source>
        <translation>平滑：时间常数</translation>
    </message>
    <message>
        <source>Minimum stretch for engaging, of a cycle</source>
        <translation>接合的最短行程，占周期</translation>
    </message>
    <message>
        <source>Maximum speed, of the recipe&apos;s rate</source>
        <translation>最高速度，占配方速率</translation>
    </message>
    <message>
        <source>Cam follows the master backward</source>
        <translation>凸轮随主轴反转</translation>
    </message>
    <message>
        <source>Index mark: tolerance</source>
        <translation>零位标记：公差</translation>
    </message>
    <message>
        <source>Wheel: maximum slip between two marks</source>
        <translation>测量轮：两色标间最大打滑</translation>
    </message>
    <message>
        <source>%1 · 0: automatic</source>
        <translation>%1 · 0：自动</translation>
    </message>
    <message>
        <source>%1 · 0: not monitored</source>
        <translation>%1 · 0：不监控</translation>
    </message>
    <message>
        <source>This controller has no input for an encoder. Select the clock, or use a controller with such an input.</source>
        <translation>此控制器没有编码器输入。请选择时钟，或使用带此输入的控制器。</translation>
    </message>
    <message>
        <source>The tolerance of the index mark would be half a revolution or more: %1 of %2 counts. Enter a smaller tolerance first.</source>
        <translation>零位标记的公差将达到半转或更多：%1 / %2 计数。请先输入较小的公差。</translation>
    </message>
    <message>
        <source>0: automatic, %1 · lag %2 · noise %3</source>
        <translation>0：自动，%1 · 滞后 %2 · 噪声 %3</translation>
    </message>
    <message>
        <source>One count is %1 of film</source>
        <translation>一个计数为 %1 薄膜</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterSetting</name>
    <message>
        <source>%1. Encoder at %2, phase %3.</source>
        <translation>%1。编码器位于 %2，相位 %3。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterWatch</name>
    <message>
        <source>Counts since power-up</source>
        <translation>上电后计数</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Ripple of the speed</source>
        <translation>速度波动</translation>
    </message>
    <message>
        <source>Phase in use</source>
        <translation>当前相位</translation>
    </message>
    <message>
        <source>Error of the measured position</source>
        <translation>测量位置误差</translation>
    </message>
    <message>
        <source>Lead of the axes</source>
        <translation>轴超前量</translation>
    </message>
    <message>
        <source>Lag at the last cut</source>
        <translation>上次切割滞后</translation>
    </message>
    <message>
        <source>Line waits for the master</source>
        <translation>生产线等待主轴</translation>
    </message>
    <message>
        <source>Film until engaged</source>
        <translation>到接合的薄膜长度</translation>
    </message>
    <message>
        <source>Error of the index mark</source>
        <translation>零位标记误差</translation>
    </message>
    <message>
        <source>%1 counts</source>
        <translation>%1 计数</translation>
    </message>
    <message>
        <source>Slip between two marks</source>
        <translation>两色标间打滑</translation>
    </message>
    <message>
        <source>Input errors</source>
        <translation>输入错误</translation>
    </message>
    <message>
        <source>Film passed uncut</source>
        <translation>未切割通过的薄膜</translation>
    </message>
    <message>
        <source>%1 / turn</source>
        <translation>%1 / 转</translation>
    </message>
    <message>
        <source>The line follows the clock of the controller.</source>
        <translation>生产线跟随控制器的时钟。</translation>
    </message>
    <message>
        <source>Delay: measured only while an encoder leads the line.</source>
        <translation>延迟：仅在编码器作主轴时测量。</translation>
    </message>
    <message>
        <source>Delay: %1 cuts measured. Let the line run at least a fifth faster or slower.</source>
        <translation>延迟：已测量 %1 次切割。请让生产线速度至少改变五分之一。</translation>
    </message>
    <message>
        <source>Delay: %1 cuts measured. Let the line cut bags at a constant speed.</source>
        <translation>延迟：已测量 %1 次切割。请让生产线匀速切袋。</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2, too uncertain. Let the line run longer at two speeds.</source>
        <translation>延迟：偏差 %1 ±%2，不够可靠。请以两种速度运行更长时间。</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2. Set up offers the corrected delay.</source>
        <translation>延迟：偏差 %1 ±%2。设置中提供修正后的延迟。</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2. No correction is needed.</source>
        <translation>延迟：偏差 %1 ±%2。无需修正。</translation>
    </message>
    <message>
        <source>No data of the master. Connect the controller.</source>
        <translation>没有主轴数据。请连接控制器。</translation>
    </message>
    <message>
        <source>This controller cannot follow an encoder. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>此控制器不能跟随编码器。请更新控制器：寄存器表须为 1.6 或更新。</translation>
    </message>
    <message>
        <source>This controller has no input for an encoder. The line follows the clock of the controller.</source>
        <translation>此控制器没有编码器输入。生产线跟随控制器的时钟。</translation>
    </message>
    <message>
        <source>%1: %2 of film until engaged</source>
        <comment>%1: the state, Engaging</comment>
        <translation>%1：还需 %2 薄膜</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OrderEntry</name>
    <message>
        <source>bags</source>
        <translation>袋</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Message before the end</source>
        <translation>结束前提示</translation>
    </message>
    <message>
        <source>Enter how many good bags to make.</source>
        <translation>请输入要生产的合格袋数。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OrderOffers</name>
    <message>
        <source>This order is for the machine %1; this one is %2.</source>
        <translation>此订单属于机器 %1；本机是 %2。</translation>
    </message>
    <message>
        <source>It waits in the queue, or was started already.</source>
        <translation>它已在队列中，或曾经启动过。</translation>
    </message>
    <message>
        <source>%1 bags</source>
        <translation>%1 袋</translation>
    </message>
    <message>
        <source>signed by %1</source>
        <comment>person</comment>
        <translation>由 %1 签名</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Orders</name>
    <message>
        <source>orders</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>%1 is complete: %2 good bags, %3 rejected, %4 empty.</source>
        <comment>%1: an order</comment>
        <translation>%1 已完成：合格 %2 袋，剔除 %3 袋，空袋 %4 个。</translation>
    </message>
    <message>
        <source>%1: %2 bags left.</source>
        <comment>%1: an order</comment>
        <translation>%1：还剩 %2 袋。</translation>
    </message>
    <message>
        <source>The queue is full: %1 orders wait. Start or remove one first.</source>
        <translation>队列已满：%1 个订单在等待。请先开始或删除一个。</translation>
    </message>
    <message>
        <source>The panel&apos;s database is not open yet. Try again.</source>
        <translation>面板数据库尚未打开。请重试。</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>未连接到控制器。</translation>
    </message>
    <message>
        <source>The controller has no program for a packing machine. Download a recipe first.</source>
        <translation>控制器没有包装机程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The controller&apos;s order is being read. Try again.</source>
        <translation>正在读取控制器的订单。请重试。</translation>
    </message>
    <message>
        <source>An order is under way. End it first.</source>
        <translation>一个订单正在进行。请先结束它。</translation>
    </message>
    <message>
        <source>This order is for %1, and the controller has %2. Download %1 first.</source>
        <comment>recipes</comment>
        <translation>此订单用于 %1，而控制器中是 %2。请先下载 %1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OutputTry</name>
    <message>
        <source>A filled lamp means on. This controller cannot try outputs; update its firmware.</source>
        <translation>实心指示灯表示接通。此控制器不能测试输出，请更新固件。</translation>
    </message>
    <message>
        <source>%1 is on while you hold the key.</source>
        <translation>按住按键时，%1 接通。</translation>
    </message>
    <message>
        <source>Release the key before you try again.</source>
        <translation>请先松开按键，再重新测试。</translation>
    </message>
    <message>
        <source>A filled lamp means on. Hold Try to switch an output on.</source>
        <translation>实心指示灯表示接通。按住“测试”接通输出。</translation>
    </message>
    <message>
        <source>A filled lamp means on. Outputs can be tried at standstill.</source>
        <translation>实心指示灯表示接通。停机时可以测试输出。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingFields</name>
    <message>
        <source>Knife: max. speed step at a change</source>
        <translation>刀轴：换程序时最大速度阶跃</translation>
    </message>
    <message>
        <source>Film: max. speed step at a change</source>
        <translation>薄膜：换程序时最大速度阶跃</translation>
    </message>
    <message>
        <source>Infeed: max. speed step at a change</source>
        <translation>进料：换程序时最大速度阶跃</translation>
    </message>
    <message>
        <source>Mark tracking</source>
        <translation>色标跟踪</translation>
    </message>
    <message>
        <source>Phase gain: correction of slip</source>
        <translation>相位增益：打滑修正</translation>
    </message>
    <message>
        <source>Length gain: correction of length</source>
        <translation>长度增益：长度修正</translation>
    </message>
    <message>
        <source>Mark sensor to knife</source>
        <translation>色标传感器到切刀</translation>
    </message>
    <message>
        <source>Cut offset behind its mark</source>
        <translation>切断滞后色标的距离</translation>
    </message>
    <message>
        <source>Mark window, ±</source>
        <translation>色标窗口，±</translation>
    </message>
    <message>
        <source>Missing marks in a row before stop</source>
        <translation>停机前连续缺失色标数</translation>
    </message>
    <message>
        <source>Phase limit: max. shift of a cut</source>
        <translation>相位限值：每次切断的最大移动量</translation>
    </message>
    <message>
        <source>Length limit: max. change of a bag</source>
        <translation>长度限值：每袋的最大变化量</translation>
    </message>
    <message>
        <source>Length trim without marks</source>
        <translation>不跟踪色标时的长度微调</translation>
    </message>
    <message>
        <source>Anti-cut: knife stays open over product</source>
        <translation>防切：有产品时切刀保持张开</translation>
    </message>
    <message>
        <source>Clearance on both sides of a cut</source>
        <translation>切断两侧无产品的距离</translation>
    </message>
    <message>
        <source>Skipped cuts in a row before stop</source>
        <translation>停机前连续略过切断数</translation>
    </message>
    <message>
        <source>Film waits for a missing product</source>
        <translation>缺产品时薄膜等待</translation>
    </message>
    <message>
        <source>Product placement to knife</source>
        <translation>产品落点到切刀</translation>
    </message>
    <message>
        <source>Product eye to placement</source>
        <translation>产品光电到落点</translation>
    </message>
    <message>
        <source>Product pitch on the infeed</source>
        <translation>进料产品间距</translation>
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
        <source>%1 · no suggestion: the mark positions do not vary (%2 bags)</source>
        <translation>%1 · 无建议：色标位置没有变化（%2 袋）</translation>
    </message>
    <message>
        <source>%1 · margin ±%5: film slip %2 per bag, sensor std dev %3 (%4 bags)</source>
        <translation>%1 · 误差 ±%5：薄膜每袋打滑 %2，传感器标准差 %3（%4 袋）</translation>
    </message>
    <message>
        <source>%1 · too few bags for a suggestion, still needed: %2</source>
        <translation>%1 · 袋数不足，无法给出建议，还需 %2 袋</translation>
    </message>
    <message>
        <source>Mark sensor: dead time</source>
        <translation>色标传感器：滞后时间</translation>
    </message>
    <message>
        <source>Product eye: dead time, product comes</source>
        <translation>产品光电：滞后时间，产品到达</translation>
    </message>
    <message>
        <source>Product eye: dead time, product ends</source>
        <translation>产品光电：滞后时间，产品离开</translation>
    </message>
    <message>
        <source>%1 · learned from starts, stops and changes of rate: too few marks so far</source>
        <translation>%1 · 由启动、停止和变速学习：目前色标太少</translation>
    </message>
    <message>
        <source>%1 · learned: %2 ms, margin ±%3 ms</source>
        <translation>%1 · 学习值：%2 ms，误差 ±%3 ms</translation>
    </message>
    <message>
        <source>%1. It answers later than entered: clean and check it.</source>
        <translation>%1。其响应比设定值慢：请清洁并检查。</translation>
    </message>
    <message>
        <source>Knife %1 cuts behind its place by</source>
        <translation>切刀 %1 偏后</translation>
    </message>
    <message>
        <source>Mark sensor: more dead time at a mark&apos;s end</source>
        <translation>色标传感器：色标结束处附加滞后</translation>
    </message>
    <message>
        <source>Mark width, minimum</source>
        <translation>色标宽度，最小</translation>
    </message>
    <message>
        <source>Mark width, maximum</source>
        <translation>色标宽度，最大</translation>
    </message>
    <message>
        <source>Ignored film behind a mark</source>
        <translation>色标后屏蔽的薄膜</translation>
    </message>
    <message>
        <source>Product length, maximum</source>
        <translation>产品长度，最大</translation>
    </message>
    <message>
        <source>Jaws close before the cut by</source>
        <translation>封切口闭合，切断前</translation>
    </message>
    <message>
        <source>Jaws open behind the cut by</source>
        <translation>封切口打开，切断后</translation>
    </message>
    <message>
        <source>Delay before the knife opens after a stop</source>
        <translation>停止后切刀打开前的延时</translation>
    </message>
    <message>
        <source>Closed jaws spoil the film after</source>
        <translation>闭合的封切口损坏薄膜的时间</translation>
    </message>
    <message>
        <source>No mark would fit: at least %1, at most %2. Change the other one first.</source>
        <translation>没有色标符合：最小 %1，最大 %2。请先更改另一个值。</translation>
    </message>
    <message>
        <source>Thread up: knife open until a mark is there</source>
        <translation>穿膜：色标到达前切刀打开</translation>
    </message>
    <message>
        <source>%1 · 0: not used</source>
        <translation>%1 · 0：不使用</translation>
    </message>
    <message>
        <source>Jam detection: stop at once at a jam</source>
        <translation>卡料检测：卡料时立即停止</translation>
    </message>
    <message>
        <source>Jam detection: knife closes before the cut by</source>
        <translation>卡料检测：切刀开始闭合，切断前</translation>
    </message>
    <message>
        <source>Jam detection: margin beyond the torque band</source>
        <translation>卡料检测：超出转矩范围的余量</translation>
    </message>
    <message>
        <source>Jam: time from full speed to standstill</source>
        <translation>卡料：从全速到停止的时间</translation>
    </message>
    <message>
        <source>Jam: knife goes back by</source>
        <translation>卡料：切刀后退</translation>
    </message>
    <message>
        <source>The jaws would stay closed after a jam: they close %1° before the cut. The knife must go back by more than that.</source>
        <translation>卡料后封切口仍会闭合：封切口在切断前 %1° 闭合。切刀后退的角度必须更大。</translation>
    </message>
    <message>
        <source>Too short for the knife: with its maximum acceleration it needs %1 ms from its speed at the cut. Enter at least that time.</source>
        <translation>对切刀来说太短：以最大加速度从切断时的速度停下需要 %1 ms。请输入不小于该值的时间。</translation>
    </message>
    <message>
        <source>%1 · to measure this, fix one part on the infeed and run at two speeds</source>
        <translation>%1 · 要测量此值，请在进料上固定一个工件，并以两种速度运行</translation>
    </message>
    <message>
        <source>%1 · not offered: margin ±%2 ms, at most %3 ms. Fix one part on the infeed and run at two speeds.</source>
        <translation>%1 · 不建议：误差 ±%2 ms，最大 %3 ms。请在进料上固定一个工件，并以两种速度运行。</translation>
    </message>
    <message>
        <source>%1 · measured: %2 ms, margin ±%3 ms</source>
        <translation>%1 · 实测：%2 ms，误差 ±%3 ms</translation>
    </message>
    <message>
        <source>The end of a mark would have a dead time of %1 ms; it must be 0 to %2 ms. Change the other time first.</source>
        <translation>色标末端的滞后时间将为 %1 ms；必须为 0 至 %2 ms。请先更改另一个时间。</translation>
    </message>
    <message>
        <source>%1 · leaves out the cut: enter both angles, or 0 for both</source>
        <translation>%1 · 未包含切断点：请输入两个角度，或都设为 0</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingSetup</name>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>没有包装机的数据。请连接控制器并下载旋转切刀的配方。</translation>
    </message>
    <message>
        <source>Waiting: marks are measured while the film runs.</source>
        <translation>等待中：薄膜运行时才测量色标。</translation>
    </message>
    <message>
        <source>%1 of %2 marks measured …</source>
        <translation>已测量 %1 / %2 个色标…</translation>
    </message>
    <message>
        <source>Measures the distances of the next %1 marks while the machine runs.</source>
        <translation>测量随后 %1 个色标的间距，机器继续运行。</translation>
    </message>
    <message>
        <source>Start the machine: marks are measured while the film runs, with mark tracking on or off.</source>
        <translation>请启动机器：薄膜运行时测量色标，与色标跟踪是否打开无关。</translation>
    </message>
    <message>
        <source>The mark distance is %1 (±%2), the recipe cuts %3. The difference exceeds the length limit: this film does not match this recipe.</source>
        <translation>色标间距 %1（±%2），配方袋长 %3。差值超过长度限值：此薄膜与此配方不符。</translation>
    </message>
    <message>
        <source>The mark distance is %1 (±%2), the recipe cuts %3.</source>
        <translation>色标间距 %1（±%2），配方袋长 %3。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PagedLogBase</name>
    <message>
        <source>Only the newest %1 rows are exported. Set a time by the filter for older ones.</source>
        <translation>只导出最新的 %1 行。要导出更早的行，请在筛选中设置时间。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ParameterField</name>
    <message>
        <source>Jog speed</source>
        <translation>点动速度</translation>
    </message>
    <message>
        <source>Reference run speed</source>
        <translation>回零速度</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ParameterFields</name>
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
        <source>Not in this controller. Update its firmware.</source>
        <translation>此控制器没有该设置。请更新固件。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramDownload</name>
    <message>
        <source>Not possible: the machine cannot execute this recipe.</source>
        <translation>无法下载：机器不能执行此配方。</translation>
    </message>
    <message>
        <source>Not possible: this controller cannot execute this kind of program.</source>
        <translation>无法下载：该控制器不能执行这类程序。</translation>
    </message>
    <message>
        <source>Controller: unknown</source>
        <translation>控制器：未知</translation>
    </message>
    <message>
        <source>Controller: reading the program …</source>
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
        <source>Active in controller: generation %1 · identical</source>
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
        <source>No connection. Last known program in the controller: generation %1</source>
        <translation>没有连接。控制器中最后已知的程序：第 %1 代</translation>
    </message>
    <message>
        <source>The controller already has this program.</source>
        <translation>控制器中已有此程序。</translation>
    </message>
    <message>
        <source>The new recipe is used from the next start.</source>
        <translation>新配方从下次启动起使用。</translation>
    </message>
    <message>
        <source>%1 Confirm the advance, or close the cam.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1请确认净进给，或闭合凸轮。</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · another kind of program</source>
        <translation>控制器中运行：第 %1 代 · 另一种程序</translation>
    </message>
    <message>
        <source>Not possible: the disk with the data of this machine is missing. The controller keeps its program.</source>
        <translation>无法执行：存有本机数据的磁盘缺失。控制器保留其程序。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramProof</name>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>控制器没有程序。请先下载配方。</translation>
    </message>
    <message>
        <source>The connection is lost. The comparison continues when it is restored.</source>
        <translation>连接中断。连接恢复后继续比较。</translation>
    </message>
    <message>
        <source>Reading the table back from the controller …</source>
        <translation>正在从控制器回读数据表…</translation>
    </message>
    <message>
        <source>Reads back and compares every register of the table, also while the machine runs.</source>
        <translation>回读数据表的每个寄存器并逐一比较，机器运行时也可进行。</translation>
    </message>
    <message>
        <source>what this panel downloaded</source>
        <translation>本面板下载的内容</translation>
    </message>
    <message>
        <source>the table computed again from its recipe</source>
        <translation>按其配方重新计算的数据表</translation>
    </message>
    <message>
        <source>the controller&apos;s own checksum</source>
        <translation>控制器自己的校验和</translation>
    </message>
    <message>
        <source>Identical: the table of generation %1 matches %2. CRC-32 %3.</source>
        <comment>%2: &quot;the controller&apos;s own checksum&quot;</comment>
        <translation>一致：第 %1 代数据表与%2相符。CRC-32 %3。</translation>
    </message>
    <message>
        <source>Identical: all %1 registers of generation %2 match %3. CRC-32 %4.</source>
        <comment>%3: for example &quot;what this panel downloaded&quot;</comment>
        <translation>一致：第 %2 代的全部 %1 个寄存器与%3相符。CRC-32 %4。</translation>
    </message>
    <message>
        <source>The controller&apos;s program changed during the comparison. Compare again.</source>
        <translation>比较期间控制器的程序已更换。请重新比较。</translation>
    </message>
    <message>
        <source>Canceled without a result.</source>
        <translation>已取消，没有结果。</translation>
    </message>
    <message>
        <source>Different: the table read back has CRC-32 %1, the controller reports %2. Download the recipe again.</source>
        <translation>不一致：回读的数据表 CRC-32 为 %1，控制器报告为 %2。请重新下载配方。</translation>
    </message>
    <message>
        <source>first %1: %2 instead of %3</source>
        <comment>register: its value, expected value</comment>
        <translation>第一个是 %1：为 %2，应为 %3</translation>
    </message>
    <message>
        <source>Different: 1 of %1 registers does not match %2, %3. Download the recipe again.</source>
        <translation>不一致：%1 个寄存器中有 1 个与%2不符，%3。请重新下载配方。</translation>
    </message>
    <message>
        <source>Different: %1 of %2 registers do not match %3, %4. Download the recipe again.</source>
        <translation>不一致：%2 个寄存器中有 %1 个与%3不符，%4。请重新下载配方。</translation>
    </message>
    <message>
        <source>Not compared: there is no connection to the controller.</source>
        <translation>未比较：没有连接到控制器。</translation>
    </message>
    <message>
        <source>Not compared: another comparison is in progress.</source>
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
        <translation>%1 · 第 %2 版，第 %3 代，CRC-32 %4</translation>
    </message>
    <message>
        <source>none: no program after a power loss</source>
        <translation>无：断电后没有程序</translation>
    </message>
    <message>
        <source>identical: kept after a power loss</source>
        <translation>相同：断电后仍保留</translation>
    </message>
    <message>
        <source>different, CRC-32 %1: restored after a power loss</source>
        <translation>另一个程序，CRC-32 %1：断电后恢复为它</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RampControl</name>
    <message>
        <source>Peak acceleration</source>
        <translation>峰值加速度</translation>
    </message>
    <message>
        <source>RMS acceleration</source>
        <translation>均方根加速度</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>峰值转速</translation>
    </message>
    <message>
        <source>Highest rate</source>
        <translation>最高速率</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 r/min</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Ratios: %1 %</source>
        <comment>position between slow and gentle</comment>
        <translation>比例：%1 %</translation>
    </message>
    <message>
        <source>Ratios: %1</source>
        <comment>set by hand, gentle, cool or slow</comment>
        <translation>比例：%1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ReasonEditor</name>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>The name is longer than %1 letters.</source>
        <translation>名称超过 %1 个字符。</translation>
    </message>
    <message>
        <source>The name cannot contain a slash.</source>
        <translation>名称不能包含斜杠。</translation>
    </message>
    <message>
        <source>This name is already in the list.</source>
        <translation>列表中已有此名称。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeCodes</name>
    <message>
        <source>Any reel</source>
        <translation>任意膜卷</translation>
    </message>
    <message>
        <source>The code is too long. Enter at most %1 letters and digits.</source>
        <translation>条码太长。请输入不超过 %1 个字母和数字。</translation>
    </message>
    <message>
        <source>The code has characters that cannot be printed. Enter letters and digits.</source>
        <translation>条码含有不可打印的字符。请输入字母和数字。</translation>
    </message>
    <message>
        <source>This is the code of the recipe %1. Enter another code.</source>
        <translation>这是配方 %1 的条码。请输入其他条码。</translation>
    </message>
    <message>
        <source>This is the code of the film reel of %1. Enter another code.</source>
        <translation>这是 %1 的膜卷条码。请输入其他条码。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeFiles</name>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>无法使用 · %1 · %2</translation>
    </message>
    <message>
        <source>%1 Correct the file; the panel reads it again automatically.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1请更正文件，面板会自动重新读取。</translation>
    </message>
    <message>
        <source>This panel cannot show all letters of the name; missing: %1. Rename the recipe after importing.</source>
        <translation>本面板无法显示名称中的全部字符；缺少：%1 个。导入后请重命名配方。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>whole sentences</comment>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>Offered: %1</source>
        <comment>recipe and version</comment>
        <translation>收到：%1</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <comment>recipe, number</comment>
        <translation>%1，版本 %2</translation>
    </message>
    <message>
        <source>signed by %1</source>
        <comment>person</comment>
        <translation>由 %1 签名</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeWindow</name>
    <message>
        <source>%1, lowest</source>
        <comment>name of a value</comment>
        <translation>%1，下限</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <comment>name of a value</comment>
        <translation>%1，上限</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeWindows</name>
    <message>
        <source>%1: the lowest value is above the highest. Correct one of them.</source>
        <translation>%1：下限高于上限。请更正其中之一。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Recipes</name>
    <message>
        <source>No version of these recipes can be read: %1. Restore a backup that has them.</source>
        <translation>以下配方的所有版本均无法读取：%1。请恢复包含这些配方的备份。</translation>
    </message>
    <message>
        <source>%1 was imported as %2, version %3.</source>
        <comment>file, recipe</comment>
        <translation>%1 已导入为 %2，第 %3 版。</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>date, person</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 · version %2, %3</source>
        <comment>kind of program, number, when it was saved</comment>
        <translation>%1 · 第 %2 版，%3</translation>
    </message>
    <message>
        <source>%1 · Version %2 cannot be read. Check this version, then save it.</source>
        <comment>note, number</comment>
        <translation>%1 · 版本 %2 无法读取。请检查本版本后保存。</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>The name is too long. Enter at most %1 letters, or a third as many Chinese characters.</source>
        <translation>名称太长。最多 %1 个字母，汉字为其三分之一。</translation>
    </message>
    <message>
        <source>A recipe with this name already exists.</source>
        <translation>已有同名配方。</translation>
    </message>
    <message>
        <source>Saved: %1, version %2.</source>
        <translation>已保存：%1，第 %2 版。</translation>
    </message>
    <message>
        <source>%1 was created with default values and opened. Set your values on the Motion page.</source>
        <translation>%1 已新建并打开，采用默认值。请在“运动”页设定您的数值。</translation>
    </message>
    <message>
        <source>%1 was created as a copy and opened.</source>
        <translation>%1 已作为副本新建并打开。</translation>
    </message>
    <message>
        <source>A deleted recipe has the name %1. Choose another name.</source>
        <translation>已删除的配方占用名称 %1。请另选名称。</translation>
    </message>
    <message>
        <source>Renamed %1 to %2.</source>
        <translation>已将 %1 改名为 %2。</translation>
    </message>
    <message>
        <source>%1 was deleted; its versions are kept.</source>
        <translation>%1 已删除，其各版本仍保留。</translation>
    </message>
    <message>
        <source>%1 · v%2</source>
        <translation>%1 · 第 %2 版</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>第 %1 版</translation>
    </message>
    <message>
        <source>The file becomes the new recipe %1. The data of this machine stay unchanged.</source>
        <translation>将导入为新配方 %1。本机数据不变。</translation>
    </message>
    <message>
        <source>The file is identical to %1, version %2; nothing changes.</source>
        <translation>与 %1 第 %2 版相同，不会改变。</translation>
    </message>
    <message>
        <source>The file becomes version %2 of %1; earlier versions are kept.</source>
        <translation>将成为 %1 的第 %2 版，以前的版本均保留。</translation>
    </message>
    <message>
        <source>%1 Changes: %2.</source>
        <comment>whole sentence, list</comment>
        <translation>%1更改：%2。</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <comment>name, old value, new value</comment>
        <translation>%1 由 %2 改为 %3</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between changes</comment>
        <translation>；</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <comment>list</comment>
        <translation>
            <numerusform>%1，另有 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is a %2 on this panel and a %3 in the file. Rename one of them.</source>
        <translation>%1 在本面板上是%2，在文件中是%3。请重命名其中一个。</translation>
    </message>
    <message>
        <source>The file has version %2 of %1; this panel has version %3. An older version is not imported; open it from the versions of the recipe.</source>
        <translation>文件中是 %1 的第 %2 版，本面板有第 %3 版。不导入较旧的版本，请从该配方的版本中打开。</translation>
    </message>
    <message>
        <source>This machine cannot run the recipe. %1</source>
        <comment>whole sentences</comment>
        <translation>本机无法运行该配方。%1</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>Peak motor torque</source>
        <translation>电机峰值转矩</translation>
    </message>
    <message>
        <source>RMS motor torque</source>
        <translation>电机均方根转矩</translation>
    </message>
    <message>
        <source>Highest RMS torque</source>
        <translation>最高均方根转矩</translation>
    </message>
    <message>
        <source>%1, %2 Nm</source>
        <comment>recipe, torque</comment>
        <translation>%1，%2 Nm</translation>
    </message>
    <message>
        <source>The file of the open recipe was lost or damaged. Opened instead: %1, version %2, with this panel&apos;s machine data.</source>
        <translation>已打开配方的文件丢失或损坏。已改为打开：%1，版本 %2，使用本面板的机器数据。</translation>
    </message>
    <message>
        <source>The machine data for %1 were lost or damaged. Those saved with the recipe %2 are used; check them on the Motion page.</source>
        <translation>%1 的机器数据丢失或损坏。现使用与配方 %2 一起保存的数据；请在“运动”页核对。</translation>
    </message>
    <message>
        <source>The name has characters that nobody can see. Enter the name again.</source>
        <translation>名称含有不可见字符。请重新输入名称。</translation>
    </message>
    <message numerus="yes">
        <source>%n recipes were imported.</source>
        <translation>
            <numerusform>已导入 %n 个配方。</numerusform>
        </translation>
    </message>
    <message>
        <source>new</source>
        <comment>recipe</comment>
        <translation>新配方</translation>
    </message>
    <message>
        <source>is here already</source>
        <comment>recipe</comment>
        <translation>已存在</translation>
    </message>
    <message>
        <source>becomes version %1</source>
        <translation>成为版本 %1</translation>
    </message>
    <message>
        <source>The file of the open recipe was lost or damaged. Opened instead: a new recipe, with this panel&apos;s machine data.</source>
        <translation>已打开配方的文件丢失或损坏。已改为打开：新配方，使用本面板的机器数据。</translation>
    </message>
    <message>
        <source>%1 is in the list again.</source>
        <translation>%1 已回到列表中。</translation>
    </message>
    <message>
        <source>The recipe %1 is not among the recipes of this panel. Save it first.</source>
        <translation>本面板的配方中没有 %1。请先保存。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RegisterInspector</name>
    <message>
        <source>All groups</source>
        <translation>所有组</translation>
    </message>
    <message>
        <source>Tap a register to read its description or to write a value.</source>
        <translation>点按寄存器查看说明或写入数值。</translation>
    </message>
    <message>
        <source>Writable: %1 to %2, default %3.</source>
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
        <source>Written and read back from the controller: %1.</source>
        <translation>已写入并从控制器回读：%1。</translation>
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
        <source>New files will be written to %1.</source>
        <translation>新文件将写入 %1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Scan</name>
    <message>
        <source>The prefix is not possible. Enter up to 8 letters, digits or signs of ASCII without spaces.</source>
        <translation>前缀无效。请输入不超过 8 个 ASCII 字母、数字或符号，不含空格。</translation>
    </message>
    <message>
        <source>The code was not read completely. Scan again.</source>
        <translation>条码未读完整。请重新扫描。</translation>
    </message>
    <message>
        <source>No recipe has the code %1. Enter the code with its recipe on the Recipes page.</source>
        <translation>没有配方使用条码 %1。请在“配方”页面为配方输入该条码。</translation>
    </message>
    <message>
        <source>%1 and %2 have the same code %3. Give one of them another code.</source>
        <translation>%1 和 %2 的条码同为 %3。请为其中一个更换条码。</translation>
    </message>
    <message>
        <source>An entry is open. Confirm or cancel the entry, then scan again.</source>
        <translation>有未完成的输入。请先确认或取消输入，然后重新扫描。</translation>
    </message>
    <message>
        <source>Complete the first start, then scan again.</source>
        <translation>请先完成首次启动，然后重新扫描。</translation>
    </message>
    <message>
        <source>The recipes are still being read. Scan again.</source>
        <translation>正在读取配方。请重新扫描。</translation>
    </message>
    <message>
        <source>A download is running. Scan again when the download has ended.</source>
        <translation>正在下载。请在下载结束后重新扫描。</translation>
    </message>
    <message>
        <source>Film reel %1 is the right one for this recipe.</source>
        <translation>膜卷 %1 与此配方相符。</translation>
    </message>
    <message>
        <source>Film reel %1 is loaded. The next recipe is compared with it.</source>
        <translation>膜卷 %1 已装入，将与下一个配方比对。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SegmentModel</name>
    <message>
        <source>%1 – %2°</source>
        <translation>%1 – %2°</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>End position</source>
        <translation>终点位置</translation>
    </message>
    <message>
        <source>Start speed</source>
        <translation>起点速度</translation>
    </message>
    <message>
        <source>Start acceleration</source>
        <translation>起点加速度</translation>
    </message>
    <message>
        <source>End speed</source>
        <translation>终点速度</translation>
    </message>
    <message>
        <source>End acceleration</source>
        <translation>终点加速度</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ServiceBundle</name>
    <message>
        <source>CamPanel service %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel 服务包 %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Settings</name>
    <message>
        <source>Unit number</source>
        <translation>站号</translation>
    </message>
    <message>
        <source>Permission denied: add the user to the group &quot;%1&quot;.</source>
        <translation>无权限：请将用户加入“%1”组。</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing. The last good copy is used; check the settings.</source>
        <translation>设置文件已损坏或丢失。现使用最近的完好副本；请检查设置。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Glove mode</source>
        <translation>手套模式</translation>
    </message>
    <message>
        <source>bag tolerance, mm</source>
        <translation>袋长公差，mm</translation>
    </message>
    <message>
        <source>minutes until logout</source>
        <translation>自动退出分钟数</translation>
    </message>
    <message>
        <source>operator login required</source>
        <translation>操作员须登录</translation>
    </message>
    <message>
        <source>hold to start</source>
        <translation>按住启动</translation>
    </message>
    <message>
        <source>seconds of a stop until its question</source>
        <translation>停机多少秒后询问原因</translation>
    </message>
    <message>
        <source>ideal rate, pieces/min</source>
        <translation>理想速率，件/分</translation>
    </message>
    <message>
        <source>start of the shifts</source>
        <translation>班次开始时间</translation>
    </message>
    <message>
        <source>working days</source>
        <translation>工作日</translation>
    </message>
    <message>
        <source>reasons of a stop</source>
        <translation>停机原因</translation>
    </message>
    <message>
        <source>scanner prefix</source>
        <translation>扫码枪前缀</translation>
    </message>
    <message>
        <source>scanner suffix</source>
        <translation>扫码枪后缀</translation>
    </message>
    <message>
        <source>time between scanned keys, ms</source>
        <translation>扫码按键间隔，ms</translation>
    </message>
    <message>
        <source>screen rotation, degrees</source>
        <translation>屏幕旋转，度</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing and has no good copy. No controller is selected: select one on the Settings page, under Connection.</source>
        <translation>设置文件已损坏或丢失，且没有完好的副本。未选择控制器：请在“设置”页的“通信”中选择。</translation>
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
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Screen off without touch, at standstill</source>
        <translation>静止且无触摸时关闭屏幕</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>Bag tolerance</source>
        <translation>袋长公差</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>Log out after</source>
        <translation>自动退出时间</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>Without login</source>
        <translation>未登录时</translation>
    </message>
    <message>
        <source>Start key</source>
        <translation>启动键</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>hold with a real controller</source>
        <translation>连接真实控制器时需按住</translation>
    </message>
    <message>
        <source>Hold for 0.5 s</source>
        <translation>按住 0.5 秒</translation>
    </message>
    <message>
        <source>an accidental touch does not start the machine</source>
        <translation>误触不会启动机器</translation>
    </message>
    <message>
        <source>One touch</source>
        <translation>一触即启动</translation>
    </message>
    <message>
        <source>Suffix</source>
        <translation>后缀</translation>
    </message>
    <message>
        <source>Enter key</source>
        <translation>回车键</translation>
    </message>
    <message>
        <source>Tab key</source>
        <translation>Tab 键</translation>
    </message>
    <message>
        <source>Time between keys</source>
        <translation>按键间隔</translation>
    </message>
    <message>
        <source>Question after</source>
        <translation>询问原因的时间</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Ideal rate</source>
        <translation>理想速率</translation>
    </message>
    <message>
        <source>by recipe</source>
        <translation>按配方</translation>
    </message>
    <message>
        <source>pieces/min</source>
        <translation>件/分</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>公制</translation>
    </message>
    <message>
        <source>mm, mm/s, m/s²</source>
        <translation>mm、mm/s、m/s²</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>in, in/s, ft; files stay metric</source>
        <translation>in、in/s、ft；文件保持公制</translation>
    </message>
    <message>
        <source>This text is not possible. Enter up to 64 visible characters.</source>
        <translation>不能使用该文本。请输入最多 64 个可见字符。</translation>
    </message>
    <message>
        <source>By date</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>按名称</translation>
    </message>
    <message>
        <source>By last use</source>
        <translation>按最近使用</translation>
    </message>
    <message>
        <source>name of the machine</source>
        <translation>机器名称</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>机器名称</translation>
    </message>
    <message>
        <source>step of a trim, mm</source>
        <translation>微调步长，mm</translation>
    </message>
    <message>
        <source>Step of a trim</source>
        <translation>微调步长</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ShiftReport</name>
    <message>
        <source>shift %1</source>
        <comment>name of a file: date and time</comment>
        <translation>班次 %1</translation>
    </message>
    <message>
        <source>Shift report</source>
        <translation>班次报告</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Effectiveness</source>
        <translation>效率</translation>
    </message>
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
    <message>
        <source>Run time</source>
        <translation>运行时间</translation>
    </message>
    <message>
        <source>Planned time</source>
        <translation>计划时间</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>Planned stops</source>
        <translation>计划停机</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>件数</translation>
    </message>
    <message>
        <source>Good pieces</source>
        <translation>合格件数</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>Start-up scrap</source>
        <translation>开机废品</translation>
    </message>
    <message>
        <source>Skipped cuts</source>
        <translation>跳过的切断</translation>
    </message>
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
    <message>
        <source>%1, %2</source>
        <comment>time, duration</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>reason, person</comment>
        <translation>%1（%2）</translation>
    </message>
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
    <message>
        <source>Work</source>
        <translation>生产</translation>
    </message>
    <message>
        <source>Programs that ran</source>
        <translation>运行过的程序</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Stops answered by</source>
        <translation>停机原因填写人</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>%1, %2; rejected %3, empty %4; %5</source>
        <comment>bags, state, counts, further facts of an order</comment>
        <translation>%1，%2；剔除 %3，空袋 %4；%5</translation>
    </message>
    <message>
        <source>No order in this shift.</source>
        <translation>本班次无订单。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ShiftView</name>
    <message>
        <source>ddd d MMM</source>
        <comment>date: weekday, day, month</comment>
        <translation>M月d日 ddd</translation>
    </message>
    <message>
        <source>%1, %2 – %3</source>
        <comment>date, begin and end of a shift</comment>
        <translation>%1，%2 – %3</translation>
    </message>
    <message>
        <source>Day off: no production planned</source>
        <translation>休息日：无生产计划</translation>
    </message>
    <message>
        <source>Present shift</source>
        <translation>当前班次</translation>
    </message>
    <message>
        <source>Run %1 · stops %2 · planned stops %3</source>
        <translation>运行 %1 · 停机 %2 · 计划停机 %3</translation>
    </message>
    <message>
        <source>Run %1 · stops %2 · planned stops %3 · not recorded %4</source>
        <translation>运行 %1 · 停机 %2 · 计划停机 %3 · 未记录 %4</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>time, duration, reason of a stop</comment>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>stops</source>
        <translation>停机</translation>
    </message>
    <message>
        <source>states</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SimulatedFaults</name>
    <message>
        <source>Late responses</source>
        <translation>应答延迟</translation>
    </message>
    <message>
        <source>Responses arrive 1.5 timeouts late, after the next request.</source>
        <translation>应答延迟 1.5 个超时时间，与下一个请求相遇。</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>报文丢失</translation>
    </message>
    <message>
        <source>Requests and responses that never arrive.</source>
        <translation>丢失的请求和应答。</translation>
    </message>
    <message>
        <source>Corrupted responses</source>
        <translation>应答损坏</translation>
    </message>
    <message>
        <source>Flipped bits and truncated responses.</source>
        <translation>位翻转，或应答被截断。</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Random bytes after the responses.</source>
        <translation>应答之后的随机字节。</translation>
    </message>
    <message>
        <source>A second master</source>
        <translation>第二主站</translation>
    </message>
    <message>
        <source>Its valid responses arrive in place of the panel&apos;s.</source>
        <translation>其有效应答出现在面板等待应答的位置。</translation>
    </message>
    <message>
        <source>Responses of other devices</source>
        <translation>其他设备的应答</translation>
    </message>
    <message>
        <source>Wrong unit, wrong function, wrong length.</source>
        <translation>站号、功能码或长度错误。</translation>
    </message>
    <message>
        <source>Busy controller</source>
        <translation>控制器忙</translation>
    </message>
    <message>
        <source>The controller refuses three requests in a row.</source>
        <translation>控制器连续拒绝三次请求。</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>静默</translation>
    </message>
    <message>
        <source>No data passes for two seconds.</source>
        <translation>两秒内没有任何数据通过。</translation>
    </message>
    <message>
        <source>Unplugged adapter</source>
        <translation>适配器拔出</translation>
    </message>
    <message>
        <source>The port disappears for two seconds.</source>
        <translation>端口消失两秒。</translation>
    </message>
    <message>
        <source>Restarts of the controller</source>
        <translation>控制器重启</translation>
    </message>
    <message>
        <source>Silence, then power-on with the saved program. The machine stops.</source>
        <translation>先静默，再以已保存的程序上电。机器停止。</translation>
    </message>
    <message>
        <source>Another register map</source>
        <translation>另一种寄存器表</translation>
    </message>
    <message>
        <source>Takes effect when the panel reconnects, after another fault.</source>
        <translation>其他故障后，面板重新连接时生效。</translation>
    </message>
    <message>
        <source>No faults: the connection works without errors.</source>
        <translation>没有故障：通信正常。</translation>
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
        <translation>仿真控制器拒绝了该故障：%1</translation>
    </message>
    <message>
        <source>Faults are available for the simulated controller only.</source>
        <translation>故障模拟仅适用于仿真控制器。</translation>
    </message>
    <message>
        <source>The simulated controller is not running. Connect it, then try again.</source>
        <translation>仿真控制器未运行。请连接后重试。</translation>
    </message>
    <message>
        <source>Something under the jaws</source>
        <translation>封切口下有异物</translation>
    </message>
    <message>
        <source>A packing machine with jam detection stops. Off: taken out.</source>
        <translation>打开卡料检测的包装机会停止。关：已取出。</translation>
    </message>
    <message>
        <source>Line runs</source>
        <translation>生产线运行</translation>
    </message>
    <message>
        <source>The shaft with the encoder. 100 %: %1, the active program at its rate.</source>
        <translation>装有编码器的轴。100 %：%1，即当前程序的速率。</translation>
    </message>
    <message>
        <source>Wheel slips</source>
        <translation>测量轮打滑</translation>
    </message>
    <message>
        <source>The encoder turns 5 % less than the line travels.</source>
        <translation>编码器比生产线少转 5 %。</translation>
    </message>
    <message>
        <source>Counts lost</source>
        <translation>计数丢失</translation>
    </message>
    <message>
        <source>The encoder loses 50 counts in each revolution.</source>
        <translation>编码器每转丢失 50 个计数。</translation>
    </message>
    <message>
        <source>Wires swapped</source>
        <translation>接线互换</translation>
    </message>
    <message>
        <source>A and B of the encoder: the counts go backward.</source>
        <translation>编码器的 A 和 B：计数反向。</translation>
    </message>
    <message>
        <source>Encoder signal disturbed</source>
        <translation>编码器信号受干扰</translation>
    </message>
    <message>
        <source>A and B change at once at 2 % of the edges.</source>
        <translation>2 % 的边沿上 A 和 B 同时变化。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SoftwareUpdate</name>
    <message>
        <source>Updates are installed by the package manager of this computer.</source>
        <translation>更新由本计算机的软件包管理器安装。</translation>
    </message>
    <message>
        <source>The panel closes, installs this version and comes back.</source>
        <translation>面板将关闭，安装此版本，然后重新打开。</translation>
    </message>
    <message>
        <source>CamPanel %1</source>
        <comment>version</comment>
        <translation>CamPanel %1</translation>
    </message>
    <message>
        <source>cannot be used: %1 · %2</source>
        <comment>reason, place</comment>
        <translation>不能使用：%1 · %2</translation>
    </message>
    <message>
        <source>signed by %1, %2 · %3</source>
        <comment>person, date, place</comment>
        <translation>签名人：%1，%2 · %3</translation>
    </message>
    <message>
        <source>CamPanel was not installed as a package. Install it once by the package manager.</source>
        <translation>CamPanel 不是以软件包形式安装的。请先用软件包管理器安装一次。</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Update to %1</source>
        <comment>version</comment>
        <translation>更新到 %1</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <comment>version</comment>
        <translation>恢复到 %1</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2, which cannot read the present data. Recipes, users, settings and records become those of %3; what was saved since then is put aside on this panel.</source>
        <translation>CamPanel %1 将替换为 %2，后者无法读取当前数据。配方、用户、设置和记录将恢复为 %3 的状态；此后保存的内容将另存在本面板上。</translation>
    </message>
    <message>
        <source>Preparing … The panel closes soon and comes back.</source>
        <translation>正在准备…… 面板即将关闭，然后重新打开。</translation>
    </message>
    <message>
        <source>Not updated: %1</source>
        <translation>未更新：%1</translation>
    </message>
    <message>
        <source>The update did not begin. Read journalctl -u campanel-update.</source>
        <translation>更新未开始。请查看 journalctl -u campanel-update。</translation>
    </message>
    <message>
        <source>Nothing was installed. %1</source>
        <comment>%1: whole sentences</comment>
        <translation>未安装任何内容。%1</translation>
    </message>
    <message>
        <source>CamPanel %1 could not be used. %2 The panel has put %3 and its data back.</source>
        <comment>version, whole sentences, version</comment>
        <translation>CamPanel %1 无法使用。%2面板已恢复 %3 及其数据。</translation>
    </message>
    <message>
        <source>CamPanel %1 could not be installed, and %2 could not be put back completely. Install CamPanel by the package manager. %3</source>
        <comment>version, version, whole sentences</comment>
        <translation>无法安装 CamPanel %1，也无法完全恢复 %2。请用软件包管理器安装 CamPanel。%3</translation>
    </message>
    <message>
        <source>Updated from %1 to %2.</source>
        <translation>已从 %1 更新到 %2。</translation>
    </message>
    <message>
        <source>Back from %1 to %2, with the data from before the update.</source>
        <translation>已从 %1 恢复到 %2，并恢复更新前的数据。</translation>
    </message>
    <message>
        <source>Back from %1 to %2.</source>
        <translation>已从 %1 恢复到 %2。</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2. The panel closes for some minutes; the controller keeps its program. If the new version does not start, the panel puts %1 and its data back.</source>
        <translation>CamPanel %1 将替换为 %2。面板将关闭几分钟；控制器保留其程序。如果新版本无法启动，面板将恢复 %1 及其数据。</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2. The panel closes for some minutes. Recipes and records stay.</source>
        <translation>CamPanel %1 将替换为 %2。面板将关闭几分钟。配方和记录保留不变。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::StartPermit</name>
    <message>
        <source>Start only with permit</source>
        <translation>仅凭许可启动</translation>
    </message>
    <message>
        <source>On: no start that the panel blocks.</source>
        <translation>开：面板禁止时不能启动。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::StopSetup</name>
    <message>
        <source>every day</source>
        <translation>每天</translation>
    </message>
    <message>
        <source>standard list</source>
        <translation>标准列表</translation>
    </message>
    <message>
        <source>own list (%1)</source>
        <translation>自定义列表（%1）</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Stops</name>
    <message>
        <source>Since %1, %2</source>
        <comment>time, duration</comment>
        <translation>自 %1 起，%2</translation>
    </message>
    <message>
        <source>Stop reason: %1.</source>
        <translation>停机原因：%1。</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <comment>time</comment>
        <translation>停机于 %1</translation>
    </message>
    <message>
        <source>Last stop %1</source>
        <comment>time</comment>
        <translation>上次停机 %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemClock</name>
    <message>
        <source>Asking the operating system …</source>
        <translation>正在询问操作系统 …</translation>
    </message>
    <message>
        <source>systemd-timedated does not respond. Set the clock in the operating system.</source>
        <translation>systemd-timedated 没有响应。请在操作系统中设置时钟。</translation>
    </message>
    <message>
        <source>The clock is set by hand.</source>
        <translation>时钟由人工设置。</translation>
    </message>
    <message>
        <source>The clock follows a time server.</source>
        <translation>时钟与时间服务器同步。</translation>
    </message>
    <message>
        <source>No time server has responded yet. Check the network.</source>
        <translation>时间服务器尚未响应。请检查网络。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemNetwork</name>
    <message>
        <source>Setting the address of %1. This takes up to a minute.</source>
        <translation>正在设置 %1 的地址，最多需要一分钟。</translation>
    </message>
    <message>
        <source>Asking the operating system …</source>
        <translation>正在询问操作系统 …</translation>
    </message>
    <message>
        <source>NetworkManager does not respond. Set the network in the operating system.</source>
        <translation>NetworkManager 没有响应。请在操作系统中设置网络。</translation>
    </message>
    <message>
        <source>NetworkManager manages no network port. Set the network in the operating system.</source>
        <translation>NetworkManager 没有管理任何网口。请在操作系统中设置网络。</translation>
    </message>
    <message>
        <source>%1 is not connected. Plug in the network cable.</source>
        <translation>%1 未连接。请插上网线。</translation>
    </message>
    <message>
        <source>%1 has no address yet.</source>
        <translation>%1 还没有地址。</translation>
    </message>
    <message>
        <source>%1 has the address %2.</source>
        <translation>%1 的地址为 %2。</translation>
    </message>
    <message>
        <source>%1 did not get this address; the previous one is restored. Check the cable, and that no other device has the address.</source>
        <translation>%1 未能取得该地址，已恢复原地址。请检查网线，并确认没有其他设备使用该地址。</translation>
    </message>
    <message>
        <source>No DHCP server responded; the previous address is restored. Check the cable, or enter a fixed address.</source>
        <translation>没有 DHCP 服务器响应，已恢复原地址。请检查网线，或输入固定地址。</translation>
    </message>
    <message>
        <source>The previous address was not restored: %1. Set the network in the operating system.</source>
        <translation>未能恢复原地址：%1。请在操作系统中设置网络。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemService</name>
    <message>
        <source>The operating system does not allow the panel to do this. Install polkit and the rule of the CamPanel package.</source>
        <translation>操作系统不允许面板执行此操作。请安装 polkit 和 CamPanel 软件包的规则。</translation>
    </message>
    <message>
        <source>Not set: %1</source>
        <translation>未设置：%1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TorqueWatch</name>
    <message>
        <source>The drive reports no torque.</source>
        <translation>驱动器不报告转矩。</translation>
    </message>
    <message>
        <source>Inertia and rated torque are missing in Settings, Machine.</source>
        <translation>“设置”的“机器”中缺少惯量和额定转矩。</translation>
    </message>
    <message>
        <source>The inertia is missing in Settings, Machine.</source>
        <translation>“设置”的“机器”中缺少惯量。</translation>
    </message>
    <message>
        <source>The rated torque is missing in Settings, Machine.</source>
        <translation>“设置”的“机器”中缺少额定转矩。</translation>
    </message>
    <message>
        <source>The program was made for other machine data.</source>
        <translation>该程序是按其他机器数据生成的。</translation>
    </message>
    <message>
        <source>Torque %1 % of rated, predicted %2 %, largest difference %3 %</source>
        <translation>转矩为额定的 %1 %，预测 %2 %，最大偏差 %3 %</translation>
    </message>
    <message>
        <source>Torque %1 %, predicted %2 %, max. diff. %3 %</source>
        <translation>转矩 %1 %，预测 %2 %，最大偏差 %3 %</translation>
    </message>
    <message>
        <source>Torque %1 %</source>
        <translation>转矩 %1 %</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TouchCalibration</name>
    <message>
        <source>The calibration was not set. Read journalctl -u campanel-touch.</source>
        <translation>未能设置校准。请查看 journalctl -u campanel-touch。</translation>
    </message>
    <message>
        <source>The touchscreen is calibrated in the operating system of this computer.</source>
        <translation>触摸屏在此计算机的操作系统中校准。</translation>
    </message>
    <message>
        <source>This computer has no touchscreen.</source>
        <translation>此计算机没有触摸屏。</translation>
    </message>
    <message>
        <source>The panel closes, sets the calibration and comes back.</source>
        <translation>面板将关闭，设置校准后重新打开。</translation>
    </message>
    <message>
        <source>A cross was missed. Touch the center of each cross.</source>
        <translation>有一个十字未点中。请点击每个十字的中心。</translation>
    </message>
    <message>
        <source>The touches do not fit the screen. Touch each cross where it is shown.</source>
        <translation>触点与屏幕不符。请在十字显示处点击。</translation>
    </message>
    <message>
        <source>Not set: %1</source>
        <translation>未设置：%1</translation>
    </message>
    <message>
        <source>The earlier calibration of the touchscreen did not return. %1</source>
        <translation>未能恢复触摸屏的原校准。%1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TowerFields</name>
    <message>
        <source>No data of the light tower. Connect the controller.</source>
        <translation>没有信号灯的数据。请连接控制器。</translation>
    </message>
    <message>
        <source>This controller has no light tower. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>此控制器没有信号灯。请升级控制器：寄存器表须为 1.6 或更新版本。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>蜂鸣器</translation>
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
    <message>
        <source>Single bags are left out: more than %1. Show a shorter time.</source>
        <translation>单个袋的数据未导出：超过 %1 个。请显示较短的时间段。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Value</name>
    <message>
        <source>Enter a number.</source>
        <translation>请输入数字。</translation>
    </message>
    <message>
        <source>The minimum is %1.</source>
        <translation>最小值为 %1。</translation>
    </message>
    <message>
        <source>The maximum is %1.</source>
        <translation>最大值为 %1。</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Versions</name>
    <message>
        <source>%1, version %2</source>
        <comment>recipe, number</comment>
        <translation>%1，版本 %2</translation>
    </message>
    <message>
        <source>firmware %1, register map %2.%3, serial number %4</source>
        <translation>固件 %1，寄存器表 %2.%3，序列号 %4</translation>
    </message>
    <message>
        <source>not known yet: measured from the second day on</source>
        <translation>尚未知：从第二天起测量</translation>
    </message>
    <message>
        <source>%1 MB a day</source>
        <translation>每天 %1 MB</translation>
    </message>
    <message>
        <source>%1; the disk lasts more than 100 years</source>
        <comment>growth</comment>
        <translation>%1；磁盘可用 100 年以上</translation>
    </message>
    <message>
        <source>%1; the disk lasts %2 years</source>
        <comment>growth, number</comment>
        <translation>%1；磁盘可用 %2 年</translation>
    </message>
    <message>
        <source>The disk lasts for less than five years. Free some disk space, or use a larger disk.</source>
        <translation>磁盘空间不足五年使用。请腾出磁盘空间，或更换更大的磁盘。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1, CRC-32 %2</source>
        <comment>number, number</comment>
        <translation>%1，CRC-32 %2</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>可用 %1 GB</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>网关</translation>
    </message>
    <message>
        <source>unknown: not connected</source>
        <translation>未知：未连接</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>运行中的程序</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>代次</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>打开的配方</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>磁盘</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>数据增长</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <comment>recipe</comment>
        <translation>%1，未保存</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
</context>
<context>
    <name>campanel::panel::WindowReason</name>
    <message>
        <source>Outside the approved window: %1. Give a reason, or enter an approved value.</source>
        <translation>超出批准范围：%1。请说明原因，或输入范围内的数值。</translation>
    </message>
    <message>
        <source>%1: since %2, %3</source>
        <comment>values, time, reason</comment>
        <translation>%1：自 %2 起，%3</translation>
    </message>
    <message>
        <source>%1: by %2 since %3, %4</source>
        <comment>values, person, time, reason</comment>
        <translation>%1：%2，自 %3 起，%4</translation>
    </message>
    <message>
        <source>%1: no reason given.</source>
        <comment>values</comment>
        <translation>%1：未说明原因。</translation>
    </message>
    <message>
        <source>Enter the reason for the audit trail.</source>
        <translation>请输入原因，用于审计追踪。</translation>
    </message>
    <message>
        <source>A reason has at most %1 characters. Shorten it.</source>
        <translation>原因最多 %1 个字符。请缩短。</translation>
    </message>
    <message>
        <source>The reason has characters that nobody can see. Remove them.</source>
        <translation>原因中含有不可见字符。请删除。</translation>
    </message>
</context>
</TS>
