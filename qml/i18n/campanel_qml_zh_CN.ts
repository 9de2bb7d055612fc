<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>AboutSection</name>
    <message>
        <source>CamPanel %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop on this panel is no safety function. The machine needs an emergency stop that is wired in hardware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touchscreen of an electronic-cam machine. It computes the cam, writes it to the motion controller and shows what the controller really does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence: Apache 2.0. Made with Qt (LGPL 3), Qwt (Qwt licence 1.0), libmodbus (LGPL 2.1).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BagCard</name>
    <message>
        <source>Bag length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scatter %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bag measured yet. Press Start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance ±%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BannerHost</name>
    <message>
        <source>OK</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CommandColumn</name>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>again: at once</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ConnectionSection</name>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Odd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parity and stop bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated controller runs inside this computer and moves no machine. Use it to learn and to try recipes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration m/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jerk m/s³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse frequency kHz</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DialCard</name>
    <message>
        <source>Sync window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knife</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DisplaySection</name>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light for a bright hall, dark for the night shift. Numbers and units follow the language.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DownloadSheet</name>
    <message>
        <source>Download to the controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine keeps running; the new cam begins at the next cycle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new cam is used from the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller already runs exactly this recipe.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller has no program yet; this recipe will be its first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Download</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExplanationSheet</name>
    <message>
        <source>This number is given, not derived. It may be from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this number instead</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LawPicker</name>
    <message>
        <source>Speed law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each law asks of this recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MachineSection</name>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MoreSheet</name>
    <message>
        <source>View and tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jerk curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running cam in grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows, pulses, errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the stored recipe</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotionPage</name>
    <message>
        <source>Speed law</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NavigationBar</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NextStepButton</name>
    <message>
        <source>Downloading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Download</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep over power loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the controller</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NumericKeypad</name>
    <message>
        <source>%1 to %2 · now %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OK</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParityPicker</name>
    <message>
        <source>Parity and stop bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Odd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 stop bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 stop bits</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PortPicker</name>
    <message>
        <source>Serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug in the adapter and press Search again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunPage</name>
    <message>
        <source>bags/min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bags</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>language, light or dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated or serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>knife, gear, motor limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version, safety</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SpeedCard</name>
    <message>
        <source>Knife speed mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>following error %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller has no program yet. Open Motion and press Download.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TableSheet</name>
    <message>
        <source>Step table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timer ticks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>%1 · v%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>UnitKeypad</name>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit is from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
