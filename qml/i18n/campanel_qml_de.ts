<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>AboutSection</name>
    <message>
        <source>CamPanel %1</source>
        <translation>CamPanel %1</translation>
    </message>
    <message>
        <source>Stop on this panel is not a safety function. The machine needs a hard-wired emergency stop.</source>
        <translation>Stopp an diesem Panel ist keine Sicherheitsfunktion. Die Maschine braucht einen fest verdrahteten Not-Halt.</translation>
    </message>
    <message>
        <source>Touchscreen of an electronic-cam machine. CamPanel computes the cam, downloads the program to the motion controller and shows the controller&apos;s actual values.</source>
        <translation>Touchpanel einer Maschine mit elektronischer Kurvenscheibe. CamPanel berechnet die Kurve, lädt das Programm in die Steuerung und zeigt deren Istwerte.</translation>
    </message>
    <message>
        <source>Licence: Apache 2.0. Made with Qt (LGPL 3), Qwt (Qwt licence 1.0), libmodbus (LGPL 2.1).</source>
        <translation>Lizenz: Apache 2.0. Erstellt mit Qt (LGPL 3), Qwt (Qwt-Lizenz 1.0), libmodbus (LGPL 2.1).</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisierung</translation>
    </message>
    <message>
        <source>Versions and disk</source>
        <translation>Versionen und Festplatte</translation>
    </message>
    <message>
        <source>The disk is too small</source>
        <translation>Die Festplatte ist zu klein</translation>
    </message>
    <message>
        <source>panel, gateway, controller, program</source>
        <translation>Panel, Gateway, Steuerung, Programm</translation>
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
        <translation>%1-mal</translation>
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
        <translation>Ursache</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>Aufgetreten</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Quittiert</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Shelve 1 h</source>
        <translation>1 h zurückstellen</translation>
    </message>
    <message>
        <source>Shelve 8 h</source>
        <translation>8 h zurückstellen</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Quittieren</translation>
    </message>
</context>
<context>
    <name>AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Shelved: %1</source>
        <translation>Zurückgestellt: %1</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Alle quittieren</translation>
    </message>
    <message>
        <source>No alarm is active or waiting for acknowledgment.</source>
        <translation>Kein Alarm ist aktiv oder zu quittieren.</translation>
    </message>
    <message>
        <source>Reading the log …</source>
        <translation>Protokoll wird gelesen …</translation>
    </message>
    <message>
        <source>No alarm since the start of this log.</source>
        <translation>Kein Alarm seit Beginn dieses Protokolls.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>No alarm matches the filter.</source>
        <translation>Kein Alarm entspricht dem Filter.</translation>
    </message>
    <message>
        <source>Alarm number</source>
        <translation>Alarmnummer</translation>
    </message>
    <message>
        <source>Alarms as CSV</source>
        <translation>Alarme als CSV</translation>
    </message>
    <message>
        <source>Active, %1 new</source>
        <translation>Aktiv, %1 neu</translation>
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
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>All users</source>
        <translation>Alle Benutzer</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>There are no entries of this kind. Commands, downloads, parameters, settings and logins are recorded here.</source>
        <translation>Keine Einträge dieser Art. Befehle, Laden, Parameter, Einstellungen und Anmeldungen werden hier aufgezeichnet.</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>Zurück zur Liste</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>No entry matches the filter.</source>
        <translation>Kein Eintrag entspricht dem Filter.</translation>
    </message>
    <message>
        <source>Audit trail as CSV</source>
        <translation>Protokoll als CSV</translation>
    </message>
</context>
<context>
    <name>AxesSection</name>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
</context>
<context>
    <name>AxisSheet</name>
    <message>
        <source>Present setting</source>
        <translation>Jetzige Einstellung</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>As it should</source>
        <translation>Wie es soll</translation>
    </message>
    <message>
        <source>The other way</source>
        <translation>Anders herum</translation>
    </message>
    <message>
        <source>Reverses the motor</source>
        <translation>Kehrt den Motor um</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Lassen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Read ruler</source>
        <translation>Lineal ablesen</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Eingeben …</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>One bag</source>
        <translation>Ein Beutel</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
</context>
<context>
    <name>BackupSection</name>
    <message>
        <source>Backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Create backup</source>
        <translation>Sicherung anlegen</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Rückspielen</translation>
    </message>
    <message>
        <source>Replaces all these data by a backup. The file is checked first, and the present data are saved as a backup.</source>
        <translation>Ersetzt alle diese Daten durch eine Sicherung. Zuerst wird die Datei geprüft, und der jetzige Stand wird gesichert.</translation>
    </message>
    <message>
        <source>Choose file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>Inbetriebnahmebericht</translation>
    </message>
    <message>
        <source>PDF with the open recipe (curves, limits, table), machine data, controller program and last bags.</source>
        <translation>PDF mit dem offenen Rezept (Kurven, Grenzen, Tabelle), Maschinendaten, Programm der Steuerung und letzten Beuteln.</translation>
    </message>
    <message>
        <source>Create report</source>
        <translation>Bericht erstellen</translation>
    </message>
    <message>
        <source>Working …</source>
        <translation>In Arbeit …</translation>
    </message>
    <message>
        <source>Location of the backup</source>
        <translation>Ort der Sicherung</translation>
    </message>
    <message>
        <source>Location of the report</source>
        <translation>Ort des Berichts</translation>
    </message>
    <message>
        <source>Restore this backup?</source>
        <translation>Diese Sicherung zurückspielen?</translation>
    </message>
    <message>
        <source>Service bundle</source>
        <translation>Servicepaket</translation>
    </message>
    <message>
        <source>For the manufacturer&apos;s support: open recipe, table, controller, alarms and changes of 7 days, communication, the last 10 seconds. No PINs.</source>
        <translation>Für den Service des Herstellers: offenes Rezept, Tabelle, Steuerung, Alarme und Änderungen von 7 Tagen, Kommunikation, die letzten 10 Sekunden. Keine PINs.</translation>
    </message>
    <message>
        <source>Create bundle</source>
        <translation>Paket erstellen</translation>
    </message>
    <message>
        <source>Location of the service bundle</source>
        <translation>Ort des Servicepakets</translation>
    </message>
    <message>
        <source>All data of this panel in one file: recipes with their versions, machine data, users, alarms, audit trail, bags, trends, settings.</source>
        <translation>Alle Daten dieses Panels in einer Datei: Rezepte mit Versionen, Maschinendaten, Benutzer, Alarme, Protokoll, Beutel, Trends, Einstellungen.</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung zurückspielen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Check and restore</source>
        <translation>Prüfen und rückspielen</translation>
    </message>
    <message>
        <source>There is no backup on a USB stick or on this panel. Plug a stick in; the panel finds it automatically.</source>
        <translation>Keine Sicherung auf einem USB-Stick oder diesem Panel. Stick einstecken; das Panel findet sie selbsttätig.</translation>
    </message>
</context>
<context>
    <name>BagCard</name>
    <message>
        <source>Bag length</source>
        <translation>Beutellänge</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittel %1</translation>
    </message>
    <message>
        <source>std dev %1</source>
        <translation>Std.-abw. %1</translation>
    </message>
    <message>
        <source>tolerance ±%1</source>
        <translation>Toleranz ±%1</translation>
    </message>
    <message>
        <source>last %1</source>
        <translation>zuletzt %1</translation>
    </message>
    <message>
        <source>Scrap bag</source>
        <translation>Ausschussbeutel</translation>
    </message>
</context>
<context>
    <name>BagDrawing</name>
    <message>
        <source>Knife and bag, to scale</source>
        <translation>Messer und Beutel, maßstäblich</translation>
    </message>
</context>
<context>
    <name>BannerHost</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>%1
And %2 more.</source>
        <translation>%1
Und %2 weitere.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>CamFilesSheet</name>
    <message>
        <source>There is no CSV file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.</source>
        <translation>Weder auf einem USB-Stick noch in %1 ist eine CSV-Datei. Stecken Sie einen Stick ein; das Panel findet ihn von selbst.</translation>
    </message>
    <message>
        <source>Choose the location of the new file.</source>
        <translation>Wählen Sie den Ort der neuen Datei.</translation>
    </message>
    <message>
        <source>Choose a file to view its content.</source>
        <translation>Wählen Sie eine Datei, um ihren Inhalt zu sehen.</translation>
    </message>
    <message>
        <source>Segments as CSV</source>
        <translation>Abschnitte als CSV</translation>
    </message>
    <message>
        <source>Knots as CSV</source>
        <translation>Stützpunkte als CSV</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>CSV importieren</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Write file</source>
        <translation>Datei schreiben</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
</context>
<context>
    <name>CamSheet</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>ChangePicture</name>
    <message>
        <source>The film keeps its speed.</source>
        <translation>Die Folie behält ihr Tempo.</translation>
    </message>
    <message>
        <source>down to %1 for %2</source>
        <translation>bis auf %1, für %2</translation>
    </message>
</context>
<context>
    <name>ChangeSheet</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Keypad</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>The machine runs with %1.</source>
        <translation>Die Maschine läuft mit %1.</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>Laden abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Apply at the next bag</source>
        <translation>Ab dem nächsten Beutel</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Give a reason …</source>
        <translation>Grund angeben …</translation>
    </message>
</context>
<context>
    <name>CheckedBySheet</name>
    <message>
        <source>First bag checked by</source>
        <translation>Erster Beutel geprüft von</translation>
    </message>
</context>
<context>
    <name>CleaningMode</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Clean the screen now. The panel ignores touches until the time is over; Stop still works.</source>
        <translation>Den Bildschirm jetzt reinigen. Das Panel beachtet bis zum Ablauf der Zeit keine Berührung; Stopp geht weiter.</translation>
    </message>
</context>
<context>
    <name>ClockSheet</name>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Time server</source>
        <translation>Zeitserver</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>Zeitzone</translation>
    </message>
    <message>
        <source>− 1 d</source>
        <translation>− 1 Tag</translation>
    </message>
    <message>
        <source>+ 1 d</source>
        <translation>+ 1 Tag</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 h</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 h</translation>
    </message>
    <message>
        <source>− 10 min</source>
        <translation>− 10 min</translation>
    </message>
    <message>
        <source>+ 10 min</source>
        <translation>+ 10 min</translation>
    </message>
    <message>
        <source>− 1 min</source>
        <translation>− 1 min</translation>
    </message>
    <message>
        <source>+ 1 min</source>
        <translation>+ 1 min</translation>
    </message>
</context>
<context>
    <name>CodeSheet</name>
    <message>
        <source>Film reel of %1: scan the code or enter it</source>
        <translation>Folienrolle von %1: Code scannen oder eingeben</translation>
    </message>
    <message>
        <source>Code of %1: scan or enter it (empty: the name)</source>
        <translation>Code von %1: scannen oder eingeben (leer: der Name)</translation>
    </message>
</context>
<context>
    <name>CodesSheet</name>
    <message>
        <source>Codes of %1</source>
        <translation>Codes von %1</translation>
    </message>
    <message>
        <source>Code that selects the recipe</source>
        <translation>Code, der das Rezept wählt</translation>
    </message>
    <message>
        <source>Code of the film reel</source>
        <translation>Code der Folienrolle</translation>
    </message>
</context>
<context>
    <name>CommandButton</name>
    <message>
        <source>hold longer</source>
        <translation>länger halten</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
</context>
<context>
    <name>CommandColumn</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>again: immediate</source>
        <translation>nochmals: sofort</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>nicht gesendet</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
</context>
<context>
    <name>ConfirmSheet</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ConnectionSection</name>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Ungerade</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Seriell</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Schnittstelle</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Parity and stop bits</source>
        <translation>Parität und Stoppbits</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The simulated controller runs on this computer and moves no machine. It serves for training and for testing recipes.</source>
        <translation>Die simulierte Steuerung läuft auf diesem Rechner und bewegt keine Maschine. Sie dient der Schulung und dem Erproben von Rezepten.</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
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
        <translation>gut %1 · ausgeworfen %2 · leer %3</translation>
    </message>
    <message>
        <source>First bag checked</source>
        <translation>Erster Beutel geprüft</translation>
    </message>
    <message>
        <source>End order</source>
        <translation>Auftrag beenden</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Velocity %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>Acceleration %1</source>
        <translation>Beschleunigung %1</translation>
    </message>
    <message>
        <source>Jerk %1</source>
        <translation>Ruck %1</translation>
    </message>
    <message>
        <source>Pulse frequency kHz</source>
        <translation>Pulsfrequenz kHz</translation>
    </message>
    <message>
        <source>Motor torque Nm, RMS %1</source>
        <translation>Motormoment Nm, eff. %1</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>in the controller</source>
        <translation>in der Steuerung</translation>
    </message>
</context>
<context>
    <name>CutterInputs</name>
    <message>
        <source>Speed law</source>
        <translation>Bewegungsgesetz</translation>
    </message>
    <message>
        <source>View and tools</source>
        <translation>Ansicht und Werkzeuge</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>speeds, ratios, law</source>
        <translation>Geschw., Verhältnisse</translation>
    </message>
</context>
<context>
    <name>DialCard</name>
    <message>
        <source>Sync window</source>
        <translation>Synchronbereich</translation>
    </message>
</context>
<context>
    <name>DigitPad</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>DirectionCard</name>
    <message>
        <source>Master direction</source>
        <translation>Leitrichtung</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
</context>
<context>
    <name>DisplaySection</name>
    <message>
        <source>tap</source>
        <translation>tippen</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>Screen, clock, network</source>
        <translation>Bildschirm, Uhr, Netzwerk</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Use light in a bright hall, dark in the night shift, high contrast for a dirty screen. Glove mode enlarges all keys by a quarter; numbers follow the language. Recipes and files stay metric.</source>
        <translation>Hell für eine helle Halle, dunkel für die Nachtschicht, hoher Kontrast für einen schmutzigen Bildschirm. Handschuhe vergrößern alle Tasten um ein Viertel; Zahlen folgen der Sprache. Rezepte und Dateien bleiben metrisch.</translation>
    </message>
</context>
<context>
    <name>DoctorSection</name>
    <message>
        <source>Diagnose</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>for the controller</source>
        <translation>nach der Steuerung</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>Diese nehmen</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>DownloadSheet</name>
    <message>
        <source>Download to the controller</source>
        <translation>In die Steuerung laden</translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation>In der Steuerung</translation>
    </message>
    <message>
        <source>On this panel</source>
        <translation>Auf diesem Panel</translation>
    </message>
    <message>
        <source>The controller has no program yet; this recipe becomes its first program.</source>
        <translation>Die Steuerung hat noch kein Programm; dieses Rezept wird ihr erstes.</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>Laden abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>No connection: the present program of the controller is unknown.</source>
        <translation>Keine Verbindung: das jetzige Programm der Steuerung ist unbekannt.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>The controller already has this program.</source>
        <translation>Die Steuerung hat dieses Programm schon.</translation>
    </message>
    <message>
        <source>Close the cam</source>
        <translation>Kurve schließen</translation>
    </message>
    <message>
        <source>Confirm advance</source>
        <translation>Vorschub bestätigen</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>%1 speichern</translation>
    </message>
    <message>
        <source>Give a reason …</source>
        <translation>Grund angeben …</translation>
    </message>
</context>
<context>
    <name>DryRunSection</name>
    <message>
        <source>The recipe cannot be executed. Correct it on the Motion page.</source>
        <translation>Das Rezept ist nicht ausführbar. Auf der Seite Bewegung korrigieren.</translation>
    </message>
    <message>
        <source>Master %1°</source>
        <translation>Leitachse %1°</translation>
    </message>
    <message>
        <source>Knife %1°</source>
        <translation>Messer %1°</translation>
    </message>
    <message>
        <source>%1, at full speed</source>
        <translation>%1, bei voller Geschwindigkeit</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Geschw. %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Only on the screen: the machine does not move, and nothing is sent to the controller. Turn the left dial.</source>
        <translation>Nur auf dem Bildschirm: die Maschine bewegt sich nicht, nichts wird an die Steuerung gesendet. Die linke Scheibe drehen.</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Zurück zum Anfang</translation>
    </message>
</context>
<context>
    <name>EndOrderSheet</name>
    <message>
        <source>End order</source>
        <translation>Auftrag beenden</translation>
    </message>
    <message>
        <source>End %1 at %2 good bags? An ended order cannot be continued. The run goes on.</source>
        <translation>%1 bei %2 guten Beuteln beenden? Ein beendeter Auftrag kann nicht fortgesetzt werden. Der Lauf geht weiter.</translation>
    </message>
</context>
<context>
    <name>Explained</name>
    <message>
        <source>How this is calculated</source>
        <translation>So wird gerechnet</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Ändern: %1</translation>
    </message>
</context>
<context>
    <name>ExplanationSheet</name>
    <message>
        <source>This value is entered, not calculated. The range is %1 to %2.</source>
        <translation>Dieser Wert ist eingegeben, nicht berechnet. Der Bereich ist %1 bis %2.</translation>
    </message>
    <message>
        <source>Enter this value instead</source>
        <translation>Diesen Wert eingeben</translation>
    </message>
</context>
<context>
    <name>FaultCard</name>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
</context>
<context>
    <name>FiguresSection</name>
    <message>
        <source>Communication</source>
        <translation>Kommunikation</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>Antwortzeit</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>Steuerung:</translation>
    </message>
    <message>
        <source>Responses, max. %1 per minute</source>
        <translation>Antworten, max. %1 je Minute</translation>
    </message>
    <message>
        <source>99 % of responses within, max. %1 ms</source>
        <translation>99 % der Antworten in max. %1 ms</translation>
    </message>
    <message>
        <source>Errors, max. %1 per minute</source>
        <translation>Fehler, max. %1 je Minute</translation>
    </message>
    <message>
        <source>Reset counters</source>
        <translation>Zähler zurücksetzen</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Statistics as CSV</source>
        <translation>Statistik als CSV</translation>
    </message>
</context>
<context>
    <name>FilmCard</name>
    <message>
        <source>Film</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>mark error %1</source>
        <translation>Markenfehler %1</translation>
    </message>
    <message>
        <source>Mark sensor</source>
        <translation>Markensensor</translation>
    </message>
</context>
<context>
    <name>FilmLegend</name>
    <message>
        <source>mark detected</source>
        <translation>Marke erkannt</translation>
    </message>
    <message>
        <source>missed mark, calculated</source>
        <translation>Marke fehlt, berechnet</translation>
    </message>
    <message>
        <source>next expected mark</source>
        <translation>nächste Marke</translation>
    </message>
    <message>
        <source>product</source>
        <translation>Produkt</translation>
    </message>
    <message>
        <source>next cut</source>
        <translation>nächster Schnitt</translation>
    </message>
    <message>
        <source>skipped cut</source>
        <translation>Schnitt ausgelassen</translation>
    </message>
</context>
<context>
    <name>FilmReasonSheet</name>
    <message>
        <source>Why is another film reel used?</source>
        <translation>Warum wird eine andere Folienrolle verwendet?</translation>
    </message>
    <message>
        <source>Enter the reason for the audit trail.</source>
        <translation>Grund für das Änderungsprotokoll eingeben.</translation>
    </message>
</context>
<context>
    <name>FilmSheet</name>
    <message>
        <source>Start is blocked</source>
        <translation>Start ist gesperrt</translation>
    </message>
    <message>
        <source>Override …</source>
        <translation>Übersteuern …</translation>
    </message>
</context>
<context>
    <name>FirstController</name>
    <message>
        <source>Simulated controller</source>
        <translation>Simulierte Steuerung</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Use this connection</source>
        <translation>Diese Verbindung nehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Find the controller</source>
        <translation>Steuerung suchen</translation>
    </message>
    <message>
        <source>on all ports with the usual settings; takes seconds</source>
        <translation>übliche Einstellungen; dauert Sekunden</translation>
    </message>
    <message>
        <source>Choose the port</source>
        <translation>Schnittstelle wählen</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>for training; moves no machine</source>
        <translation>zum Üben; bewegt keine Maschine</translation>
    </message>
    <message>
        <source>No controller with the usual settings. All settings take up to 15 min for each port.</source>
        <translation>Keine Steuerung mit üblichen Einstellungen. Alle Einstellungen dauern bis zu 15 min je Schnittstelle.</translation>
    </message>
    <message>
        <source>Search all settings</source>
        <translation>Alle Einstellungen suchen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
</context>
<context>
    <name>FirstLanguage</name>
    <message>
        <source>The Stop button is always available. It is not an emergency stop: use the machine&apos;s emergency-stop switch.</source>
        <translation>Die Taste Stopp ist immer verfügbar. Sie ist kein Not-Halt: dafür gibt es den Not-Halt der Maschine.</translation>
    </message>
</context>
<context>
    <name>FirstMachine</name>
    <message>
        <source>Limits and more</source>
        <translation>Grenzen und mehr</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>wie gesetzt</translation>
    </message>
</context>
<context>
    <name>FirstPicture</name>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
</context>
<context>
    <name>FirstPin</name>
    <message>
        <source>%1 is set. Add other users in Settings &gt; Users: operators start, stop and change bag length and rate, technicians also set cam and machine.</source>
        <translation>%1 ist angelegt. Weitere Benutzer unter Einstellungen &gt; Benutzer anlegen: Bediener starten, stoppen, ändern Beutellänge und Taktzahl; Techniker stellen auch Kurve und Maschine ein.</translation>
    </message>
    <message>
        <source>A PIN protects the cam, the machine and the connection; operators start, stop and change bag length and rate without a PIN. Until a PIN is set, all users have full access.</source>
        <translation>Eine PIN schützt Kurve, Maschine und Verbindung; Bediener starten, stoppen und ändern Beutellänge und Taktzahl ohne PIN. Ohne PIN dürfen alle Benutzer alles.</translation>
    </message>
    <message>
        <source>Set the first PIN</source>
        <translation>Erste PIN setzen</translation>
    </message>
</context>
<context>
    <name>FirstRecipe</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the recipe</source>
        <translation>Name des Rezepts</translation>
    </message>
</context>
<context>
    <name>FirstStart</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugang</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>First recipe</source>
        <translation>Erstes Rezept</translation>
    </message>
    <message>
        <source>First start · %1 of %2</source>
        <translation>Erster Start · %1 von %2</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Cancel download</source>
        <translation>Laden abbrechen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Laden</translation>
    </message>
</context>
<context>
    <name>FolderInUse</name>
    <message>
        <source>Another CamPanel uses the data in %1. Close the other one: this panel then starts.</source>
        <translation>Ein anderes CamPanel verwendet die Daten in %1. Das andere schließen: dann startet dieses Panel.</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>ForceCard</name>
    <message>
        <source>Force N over position</source>
        <translation>Kraft N über Position</translation>
    </message>
    <message>
        <source>at the stop: %1, %2 to %3</source>
        <translation>am Ende: %1, %2 bis %3</translation>
    </message>
</context>
<context>
    <name>FrameSheet</name>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
</context>
<context>
    <name>FramesSection</name>
    <message>
        <source>Frames</source>
        <translation>Telegramme</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>No frames of this kind.</source>
        <translation>Keine Telegramme dieser Art.</translation>
    </message>
    <message>
        <source>Frames as text</source>
        <translation>Telegramme als Text</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
</context>
<context>
    <name>HoldKey</name>
    <message>
        <source>Try %1</source>
        <translation>%1 testen</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Testen</translation>
    </message>
</context>
<context>
    <name>HomingSection</name>
    <message>
        <source>Position from reference</source>
        <translation>Position seit Referenzfahrt</translation>
    </message>
</context>
<context>
    <name>IoSection</name>
    <message>
        <source>Inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Fault bits</source>
        <translation>Störungsbits</translation>
    </message>
    <message>
        <source>Warning bits</source>
        <translation>Warnungsbits</translation>
    </message>
    <message>
        <source>No data from the controller: grey values were received last.</source>
        <translation>Keine Daten von der Steuerung: graue Werte sind die zuletzt empfangenen.</translation>
    </message>
    <message>
        <source>This controller reports the counts of its inputs, not the levels of its pins. A filled lamp means on.</source>
        <translation>Diese Steuerung meldet Zählerstände ihrer Eingänge, nicht die Pegel. Eine gefüllte Lampe heißt ein.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>Input or output</source>
        <translation>Ein- oder Ausgang</translation>
    </message>
</context>
<context>
    <name>JamSheet</name>
    <message>
        <source>Jams at the jaws</source>
        <translation>Verklemmungen an den Backen</translation>
    </message>
    <message>
        <source>Torque of the knife in per cent of its rated torque, over the angle of its shaft from the cut.</source>
        <translation>Moment des Messers in Prozent des Nennmoments, über dem Winkel seiner Welle vom Schnitt aus.</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>closes</source>
        <translation>schließt</translation>
    </message>
    <message>
        <source>learned band</source>
        <translation>gelerntes Band</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>last jam</source>
        <translation>letzte Verklemmung</translation>
    </message>
    <message>
        <source>Monitoring of the torque, reported every %1</source>
        <translation>Überwachung des Moments, gemeldet alle %1</translation>
    </message>
    <message>
        <source>Last jam; jams since power-up: %1</source>
        <translation>Letzte Verklemmung; seit dem Einschalten: %1</translation>
    </message>
    <message>
        <source>Residue on the knife</source>
        <translation>Rückstand am Messer</translation>
    </message>
</context>
<context>
    <name>JogSection</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Knife angle</source>
        <translation>Messerwinkel</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>Pulse</translation>
    </message>
</context>
<context>
    <name>KindInputs</name>
    <message>
        <source>Move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Pressen</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Stützpunkte</translation>
    </message>
    <message>
        <source>View and tools</source>
        <translation>Ansicht und Werkzeuge</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
</context>
<context>
    <name>KindSheet</name>
    <message>
        <source>A knife that follows the film while it seals</source>
        <translation>Ein Messer, das beim Siegeln der Folie folgt</translation>
    </message>
    <message>
        <source>A distance, from rest to rest</source>
        <translation>Ein Weg, von Stillstand zu Stillstand</translation>
    </message>
    <message>
        <source>From one speed to another constant speed</source>
        <translation>Von einer Geschwindigkeit zu einer anderen</translation>
    </message>
    <message>
        <source>A curve through knots that follows a master</source>
        <translation>Eine Kurve durch Stützpunkte, die einer Leitachse folgt</translation>
    </message>
    <message>
        <source>Approach, probe, press, hold, return</source>
        <translation>Anfahren, tasten, pressen, halten, Rückhub</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>Neues Programm</translation>
    </message>
    <message>
        <source>Replaces the recipe on this page; Undo restores the old recipe</source>
        <translation>Ersetzt das Rezept auf dieser Seite; Rückgängig stellt das alte wieder her</translation>
    </message>
    <message>
        <source>Segments by laws, one after another, that follow a master</source>
        <translation>Abschnitte nach Gesetzen, nacheinander, die einer Leitachse folgen</translation>
    </message>
</context>
<context>
    <name>KnifeCard</name>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Moment</translation>
    </message>
</context>
<context>
    <name>KnifeSheet</name>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>Knife speed %1</source>
        <translation>Messergeschw. %1</translation>
    </message>
</context>
<context>
    <name>KnotSheet</name>
    <message>
        <source>Add after</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Close smoothly</source>
        <translation>Glatt schließen</translation>
    </message>
    <message>
        <source>CSV files</source>
        <translation>CSV-Dateien</translation>
    </message>
    <message>
        <source>Knot %1</source>
        <translation>Stützpunkt %1</translation>
    </message>
</context>
<context>
    <name>LastStopCard</name>
    <message>
        <source>No stop yet</source>
        <translation>Noch kein Stillstand</translation>
    </message>
</context>
<context>
    <name>LawPicker</name>
    <message>
        <source>The figures are those of the ratios set by hand; the law that is gentlest with its own ramps is first</source>
        <translation>Die Zahlen gelten für die Verhältnisse von Hand; das mit eigenen Rampen sanfteste Gesetz steht zuerst</translation>
    </message>
    <message>
        <source>The gentlest law is first, each with the ramps that suit it; hold a law to compare its curves</source>
        <translation>Das sanfteste Gesetz steht zuerst, jedes mit passenden Rampen; ein Gesetz halten, um seine Kurven zu vergleichen</translation>
    </message>
    <message>
        <source>Peak values of each law for this recipe; hold a law to compare its curves</source>
        <translation>Höchstwerte jedes Gesetzes für dieses Rezept; ein Gesetz halten, um seine Kurven zu vergleichen</translation>
    </message>
    <message>
        <source>Color: %1, grey: %2</source>
        <translation>Farbig: %1, grau: %2</translation>
    </message>
    <message>
        <source>End comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
</context>
<context>
    <name>LawRow</name>
    <message>
        <source>This law exceeds a limit with this recipe. Hold the law to compare.</source>
        <translation>Dieses Gesetz überschreitet mit diesem Rezept eine Grenze. Zum Vergleichen halten.</translation>
    </message>
    <message>
        <source>This law exceeds a limit with this recipe.</source>
        <translation>Dieses Gesetz überschreitet mit diesem Rezept eine Grenze.</translation>
    </message>
</context>
<context>
    <name>LengthCard</name>
    <message>
        <source>Scrap bag, %1</source>
        <translation>Ausschuss, %1</translation>
    </message>
    <message>
        <source>Bag of %1 lengths, skipped cut</source>
        <translation>Beutel aus %1 Längen, Schnitt ausgelassen</translation>
    </message>
    <message>
        <source>Bag length, %1</source>
        <translation>Beutellänge, %1</translation>
    </message>
    <message>
        <source>Scrap bag</source>
        <translation>Ausschussbeutel</translation>
    </message>
    <message>
        <source>Bag length</source>
        <translation>Beutellänge</translation>
    </message>
    <message>
        <source>%1 of %2 within</source>
        <translation>%1 von %2 innerhalb</translation>
    </message>
    <message>
        <source>%1 of %2 within, scrap: %3</source>
        <translation>%1 von %2 innerhalb, Ausschuss: %3</translation>
    </message>
</context>
<context>
    <name>LineFilm</name>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
</context>
<context>
    <name>LogFilterDialogs</name>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
</context>
<context>
    <name>LogFilterSheet</name>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>− 7 d</source>
        <translation>− 7 d</translation>
    </message>
    <message>
        <source>− 1 d</source>
        <translation>− 1 d</translation>
    </message>
    <message>
        <source>+ 1 d</source>
        <translation>+ 1 d</translation>
    </message>
    <message>
        <source>+ 7 d</source>
        <translation>+ 7 d</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 h</translation>
    </message>
    <message>
        <source>− 10 min</source>
        <translation>− 10 min</translation>
    </message>
    <message>
        <source>+ 10 min</source>
        <translation>+ 10 min</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 h</translation>
    </message>
    <message>
        <source>This day only</source>
        <translation>Nur dieser Tag</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Unbegrenzt</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
</context>
<context>
    <name>LogFilterStrip</name>
    <message>
        <source>Only: %1</source>
        <translation>Nur: %1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle anzeigen</translation>
    </message>
</context>
<context>
    <name>LoginHost</name>
    <message>
        <source>Your PIN is too short</source>
        <translation>Ihre PIN ist zu kurz</translation>
    </message>
</context>
<context>
    <name>LoginSheet</name>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Choose your name.</source>
        <translation>Ihren Namen wählen.</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Choose your name, then enter your PIN.</source>
        <translation>Namen wählen, dann PIN eingeben.</translation>
    </message>
    <message>
        <source>Please wait …</source>
        <translation>Bitte warten …</translation>
    </message>
    <message>
        <source>Enter your PIN.</source>
        <translation>PIN eingeben.</translation>
    </message>
</context>
<context>
    <name>MachineDrawing</name>
    <message>
        <source>Drawing of the machine</source>
        <translation>Zeichnung der Maschine</translation>
    </message>
</context>
<context>
    <name>MachineSection</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Stops and shifts</source>
        <translation>Stillstände und Schichten</translation>
    </message>
    <message>
        <source>Reasons, ideal rate</source>
        <translation>Gründe, ideale Taktrate</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Panel&apos;s permit</source>
        <translation>Freigabe des Panels</translation>
    </message>
    <message>
        <source>Bag tolerance ±</source>
        <translation>Beuteltoleranz ±</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
    <message>
        <source>Light tower and horn</source>
        <translation>Signalsäule und Hupe</translation>
    </message>
    <message>
        <source>What each state shows</source>
        <translation>Anzeige je Zustand</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Pulses, direction</source>
        <translation>Pulse, Richtung</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>needs level %1</source>
        <translation>braucht die Stufe %1</translation>
    </message>
</context>
<context>
    <name>MaintenancePage</name>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Telegramme</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packung</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Trockenlauf</translation>
    </message>
    <message>
        <source>Connection to the controller</source>
        <translation>Verbindung zur Steuerung</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Panel data</source>
        <translation>Panel-Daten</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>Wartung</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
</context>
<context>
    <name>MarkWizardSheet</name>
    <message>
        <source>Mark sensor to knife</source>
        <translation>Markensensor bis Messer</translation>
    </message>
    <message>
        <source>Step 1 of 5: introduction</source>
        <translation>Schritt 1 von 5: Einführung</translation>
    </message>
    <message>
        <source>Step 2 of 5: cut bags</source>
        <translation>Schritt 2 von 5: Beutel schneiden</translation>
    </message>
    <message>
        <source>Step 3 of 5: measure</source>
        <translation>Schritt 3 von 5: Messen</translation>
    </message>
    <message>
        <source>Step 4 of 5: write</source>
        <translation>Schritt 4 von 5: Schreiben</translation>
    </message>
    <message>
        <source>Step 5 of 5: check</source>
        <translation>Schritt 5 von 5: Prüfen</translation>
    </message>
    <message>
        <source>Old distance</source>
        <translation>Alter Abstand</translation>
    </message>
    <message>
        <source>New distance</source>
        <translation>Neuer Abstand</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Read ruler</source>
        <translation>Lineal ablesen</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Eingeben …</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Erneut messen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Cut behind mark</source>
        <translation>Schnitt hinter Marke</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Delete the measurement</source>
        <translation>Messung löschen</translation>
    </message>
</context>
<context>
    <name>MasterDialCard</name>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
</context>
<context>
    <name>MasterDrawing</name>
    <message>
        <source>Encoder wheel on the film</source>
        <translation>Messrad des Gebers auf der Folie</translation>
    </message>
    <message>
        <source>Encoder on the shaft of the line</source>
        <translation>Geber auf der Welle der Linie</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>film</source>
        <translation>Folie</translation>
    </message>
</context>
<context>
    <name>MasterSection</name>
    <message>
        <source>Set up</source>
        <translation>Einrichten</translation>
    </message>
</context>
<context>
    <name>MasterSetupSection</name>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
</context>
<context>
    <name>MoreSheet</name>
    <message>
        <source>View and tools</source>
        <translation>Ansicht und Werkzeuge</translation>
    </message>
    <message>
        <source>Position curve</source>
        <translation>Positionskurve</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>Jerk curve</source>
        <translation>Ruckkurve</translation>
    </message>
    <message>
        <source>Compare with controller</source>
        <translation>Mit Steuerung vergleichen</translation>
    </message>
    <message>
        <source>Rows, pulses, errors</source>
        <translation>Zeilen, Pulse, Fehler</translation>
    </message>
    <message>
        <source>Restore stored recipe</source>
        <translation>Gespeichertes Rezept zurückholen</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>controller in grey</source>
        <translation>Steuerung in Grau</translation>
    </message>
    <message>
        <source>Edited, active, saved</source>
        <translation>Bearbeitet, aktiv, gespeichert</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Fastest rate over length</source>
        <translation>Höchste Taktzahl über der Länge</translation>
    </message>
    <message>
        <source>Regime map</source>
        <translation>Kennfeld</translation>
    </message>
    <message>
        <source>Torque curve</source>
        <translation>Momentkurve</translation>
    </message>
    <message>
        <source>needs the inertia, see Settings, Machine</source>
        <translation>braucht die Trägheit, siehe Einstellungen, Maschine</translation>
    </message>
    <message>
        <source>Operator&apos;s page</source>
        <translation>Seite für Bediener</translation>
    </message>
</context>
<context>
    <name>NameKeypad</name>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
</context>
<context>
    <name>NavigationBar</name>
    <message>
        <source>Run</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>Wartung</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>Trends</source>
        <translation>Trends</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
</context>
<context>
    <name>NetworkSheet</name>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>Network port</source>
        <translation>Netzwerkanschluss</translation>
    </message>
    <message>
        <source>By DHCP</source>
        <translation>Per DHCP</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
</context>
<context>
    <name>NewOrderSheet</name>
    <message>
        <source>New order</source>
        <translation>Neuer Auftrag</translation>
    </message>
    <message>
        <source>Good bags</source>
        <translation>Gute Beutel</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Any recipe</source>
        <translation>Beliebiges Rezept</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Order: enter or scan it</source>
        <translation>Auftrag: eingeben oder scannen</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Lot: enter or scan it</source>
        <translation>Charge: eingeben oder scannen</translation>
    </message>
    <message>
        <source>At the quantity</source>
        <translation>Bei Erreichen der Menge</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Message before</source>
        <translation>Vorher melden</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>Weiterlaufen</translation>
    </message>
    <message>
        <source>First bag checked by</source>
        <translation>Erster Beutel geprüft von</translation>
    </message>
    <message>
        <source>Bags before the end</source>
        <translation>Beutel vor dem Ende</translation>
    </message>
    <message>
        <source>Add to the queue</source>
        <translation>In die Warteschlange</translation>
    </message>
    <message>
        <source>Start order</source>
        <translation>Auftrag beginnen</translation>
    </message>
</context>
<context>
    <name>NewPinSheet</name>
    <message>
        <source>The two PINs differ. Enter the new PIN again.</source>
        <translation>Die zwei PINs sind verschieden. Die neue PIN erneut eingeben.</translation>
    </message>
    <message>
        <source>Repeat PIN</source>
        <translation>PIN wiederholen</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Neue PIN</translation>
    </message>
    <message>
        <source>Enter the same PIN again.</source>
        <translation>Dieselbe PIN noch einmal eingeben.</translation>
    </message>
    <message>
        <source>Enter the new PIN.</source>
        <translation>Die neue PIN eingeben.</translation>
    </message>
    <message>
        <source>%1 to 8 digits. A forgotten PIN cannot be read; a user of the level Service can set a new PIN.</source>
        <translation>%1 bis 8 Ziffern. Eine vergessene PIN ist nicht lesbar; ein Benutzer der Stufe Service kann eine neue setzen.</translation>
    </message>
</context>
<context>
    <name>NewUser</name>
    <message>
        <source>Name of the user</source>
        <translation>Name des Benutzers</translation>
    </message>
    <message>
        <source>PIN of %1</source>
        <translation>PIN von %1</translation>
    </message>
</context>
<context>
    <name>NewUserSheet</name>
    <message>
        <source>New user</source>
        <translation>Neuer Benutzer</translation>
    </message>
    <message>
        <source>The first user has the level Service and adds the other users. Keep this PIN safe: a forgotten PIN cannot be read from the panel.</source>
        <translation>Der erste Benutzer hat die Stufe Service und legt die anderen an. Diese PIN sicher verwahren: eine vergessene PIN ist nicht lesbar.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Next: PIN</source>
        <translation>Weiter: PIN</translation>
    </message>
</context>
<context>
    <name>NextStepButton</name>
    <message>
        <source>Downloading</source>
        <translation>Wird geladen</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>in the controller</source>
        <translation>in der Steuerung</translation>
    </message>
    <message>
        <source>next cycle</source>
        <translation>nächster Zyklus</translation>
    </message>
    <message>
        <source>to the controller</source>
        <translation>in die Steuerung</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>%1 speichern</translation>
    </message>
</context>
<context>
    <name>NumbersSheet</name>
    <message>
        <source>How this is calculated</source>
        <translation>So wird gerechnet</translation>
    </message>
</context>
<context>
    <name>NumericKeypad</name>
    <message>
        <source>%1 to %2 · now %3</source>
        <translation>%1 bis %2 · jetzt %3</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Enter a whole number.</source>
        <translation>Eine ganze Zahl eingeben.</translation>
    </message>
    <message>
        <source>%1 to %2, possible up to %3 · now %4</source>
        <translation>%1 bis %2, möglich bis %3 · jetzt %4</translation>
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
        <translation>Verfügbarkeit</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
</context>
<context>
    <name>OfferSheet</name>
    <message>
        <source>Searching …</source>
        <translation>Suche läuft …</translation>
    </message>
    <message>
        <source>Choose a file to view its content.</source>
        <translation>Eine Datei wählen, um ihren Inhalt zu sehen.</translation>
    </message>
</context>
<context>
    <name>OfferedRow</name>
    <message>
        <source>Offered: %1</source>
        <translation>Angeboten: %1</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Übernehmen</translation>
    </message>
</context>
<context>
    <name>OrderFilterSheet</name>
    <message>
        <source>Order, lot or number</source>
        <translation>Auftrag, Charge oder Nummer</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
</context>
<context>
    <name>OrderList</name>
    <message>
        <source>No order matches the filter.</source>
        <translation>Kein Auftrag passt zum Filter.</translation>
    </message>
    <message>
        <source>No order was started yet.</source>
        <translation>Noch kein Auftrag wurde begonnen.</translation>
    </message>
    <message>
        <source>rejected %1 · empty %2</source>
        <translation>ausgeworfen %1 · leer %2</translation>
    </message>
</context>
<context>
    <name>OrderRecipePicker</name>
    <message>
        <source>Recipe of the order</source>
        <translation>Rezept des Auftrags</translation>
    </message>
    <message>
        <source>Any recipe</source>
        <translation>Beliebiges Rezept</translation>
    </message>
</context>
<context>
    <name>OrderStrip</name>
    <message>
        <source>Order</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>ausgeworfen</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Orders that wait: %1</source>
        <translation>Wartende Aufträge: %1</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>Neuer Auftrag</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Offered by the plant: %1</source>
        <translation>Vom Werk angeboten: %1</translation>
    </message>
</context>
<context>
    <name>OrdersSheet</name>
    <message>
        <source>Orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>No order waits.</source>
        <translation>Kein Auftrag wartet.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Orders as CSV</source>
        <translation>Aufträge als CSV</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>Neuer Auftrag</translation>
    </message>
    <message>
        <source>Stops and OEE</source>
        <translation>Stillstände und OEE</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Not confirmed yet. Confirm or cancel first.</source>
        <translation>Nicht bestätigt. Erst bestätigen oder abbrechen.</translation>
    </message>
</context>
<context>
    <name>PackingSection</name>
    <message>
        <source>Measure marks</source>
        <translation>Marken messen</translation>
    </message>
    <message>
        <source>Sensor to knife …</source>
        <translation>Sensor bis Messer …</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Flanken</translation>
    </message>
    <message>
        <source>Jam</source>
        <translation>Klemmen</translation>
    </message>
</context>
<context>
    <name>PackingSheet</name>
    <message>
        <source>Marks, cuts and film</source>
        <translation>Marken, Schnitte und Folie</translation>
    </message>
    <message>
        <source>Mark error of the last cut</source>
        <translation>Markenfehler des letzten Schnitts</translation>
    </message>
    <message>
        <source>Mark distance</source>
        <translation>Markenabstand</translation>
    </message>
    <message>
        <source>Shift of the next cut</source>
        <translation>Versatz des nächsten Schnitts</translation>
    </message>
    <message>
        <source>Length correction</source>
        <translation>Längenkorrektur</translation>
    </message>
    <message>
        <source>Corrections at limit</source>
        <translation>Korrekturen an der Grenze</translation>
    </message>
    <message>
        <source>Tracked marks</source>
        <translation>Gefolgte Marken</translation>
    </message>
    <message>
        <source>Missing marks</source>
        <translation>Fehlende Marken</translation>
    </message>
    <message>
        <source>Unexpected marks</source>
        <translation>Unerwartete Marken</translation>
    </message>
    <message>
        <source>Cuts and film</source>
        <translation>Schnitte und Folie</translation>
    </message>
    <message>
        <source>Products</source>
        <translation>Produkte</translation>
    </message>
    <message>
        <source>Skipped cuts, product in the way</source>
        <translation>Ausgelassene Schnitte, Produkt im Weg</translation>
    </message>
    <message>
        <source>Bags without product</source>
        <translation>Beutel ohne Produkt</translation>
    </message>
    <message>
        <source>Film saved</source>
        <translation>Gesparte Folie</translation>
    </message>
    <message>
        <source>Following error of the knife</source>
        <translation>Schleppfehler des Messers</translation>
    </message>
    <message>
        <source>Following error of the film</source>
        <translation>Schleppfehler der Folie</translation>
    </message>
</context>
<context>
    <name>PagesSheet</name>
    <message>
        <source>More pages</source>
        <translation>Weitere Seiten</translation>
    </message>
</context>
<context>
    <name>ParameterFoot</name>
    <message>
        <source>Changes take effect at once. Press Save to keep the values after power-off.</source>
        <translation>Änderungen wirken sofort. Speichern drücken, damit die Werte beim Ausschalten bleiben.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>Apply %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
</context>
<context>
    <name>ParityPicker</name>
    <message>
        <source>Parity and stop bits</source>
        <translation>Parität und Stoppbits</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Ungerade</translation>
    </message>
    <message>
        <source>1 stop bit</source>
        <translation>1 Stoppbit</translation>
    </message>
    <message>
        <source>2 stop bits</source>
        <translation>2 Stoppbits</translation>
    </message>
</context>
<context>
    <name>PermitSection</name>
    <message>
        <source>Start permit</source>
        <translation>Startfreigabe</translation>
    </message>
</context>
<context>
    <name>PortPicker</name>
    <message>
        <source>Serial port</source>
        <translation>Seriell</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug the adapter in and press Search again.</source>
        <translation>Dieser Rechner hat keine serielle Schnittstelle. Adapter einstecken und erneut suchen.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
</context>
<context>
    <name>PossibleRate</name>
    <message>
        <source>Limit: %1 %2</source>
        <translation>Grenze: %1 %2</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
</context>
<context>
    <name>ProgramNames</name>
    <message>
        <source>%1 · v%2</source>
        <translation>%1 · v%2</translation>
    </message>
    <message>
        <source>%1 · v%2, edited</source>
        <translation>%1 · v%2, bearbeitet</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1, nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>ProofSheet</name>
    <message>
        <source>Program in the controller</source>
        <translation>Programm in der Steuerung</translation>
    </message>
    <message>
        <source>Edited on this panel</source>
        <translation>Auf diesem Panel bearbeitet</translation>
    </message>
    <message>
        <source>Active in the controller</source>
        <translation>In der Steuerung aktiv</translation>
    </message>
    <message>
        <source>Active in the controller (last known)</source>
        <translation>In der Steuerung aktiv (zuletzt)</translation>
    </message>
    <message>
        <source>Saved in the controller</source>
        <translation>In der Steuerung gespeichert</translation>
    </message>
    <message>
        <source>Saved in the controller (last known)</source>
        <translation>In der Steuerung gespeichert (zuletzt)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Compare with the controller</source>
        <translation>Mit der Steuerung vergleichen</translation>
    </message>
    <message>
        <source>%1, differences from the active program: %2</source>
        <translation>%1, Unterschiede zum aktiven Programm: %2</translation>
    </message>
</context>
<context>
    <name>QueueRow</name>
    <message>
        <source>One place up</source>
        <translation>Einen Platz nach oben</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Start order</source>
        <translation>Auftrag beginnen</translation>
    </message>
</context>
<context>
    <name>RateCard</name>
    <message>
        <source>Rate of the line, bags/min</source>
        <translation>Taktzahl der Linie, Beutel/min</translation>
    </message>
    <message>
        <source>Slowed to %1, bags/min</source>
        <translation>Verlangsamt auf %1, Beutel/min</translation>
    </message>
    <message>
        <source>Rate, bags/min</source>
        <translation>Taktzahl, Beutel/min</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Taktzahl</translation>
    </message>
    <message>
        <source>bags/min</source>
        <translation>Beutel/min</translation>
    </message>
    <message>
        <source>%1 bags</source>
        <translation>%1 Beutel</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
</context>
<context>
    <name>RatioSheet</name>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>Cool</source>
        <translation>Kühl</translation>
    </message>
    <message>
        <source>Gentle</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>Sealing window</source>
        <translation>Siegelbereich</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Verhältnisse</translation>
    </message>
</context>
<context>
    <name>ReasonGrid</name>
    <message>
        <source>more …</source>
        <translation>mehr …</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
</context>
<context>
    <name>ReasonList</name>
    <message>
        <source>Reasons by time</source>
        <translation>Gründe nach Dauer</translation>
    </message>
    <message>
        <source>%1 (planned)</source>
        <translation>%1 (geplant)</translation>
    </message>
    <message>
        <source>No stop in this shift.</source>
        <translation>Kein Stillstand in dieser Schicht.</translation>
    </message>
</context>
<context>
    <name>ReasonsSheet</name>
    <message>
        <source>Reasons: %1</source>
        <translation>Gründe: %1</translation>
    </message>
    <message>
        <source>Reasons of a stop</source>
        <translation>Stillstandsgründe</translation>
    </message>
    <message>
        <source>Planned stops are not counted as losses. Earlier stops keep their reason.</source>
        <translation>Geplante Stillstände zählen nicht als Verlust. Frühere Stillstände behalten ihren Grund.</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>more …</source>
        <translation>mehr …</translation>
    </message>
    <message>
        <source>This group has no reasons yet.</source>
        <translation>Diese Gruppe hat noch keine Gründe.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Standard list</source>
        <translation>Standardliste</translation>
    </message>
</context>
<context>
    <name>RecipeCard</name>
    <message>
        <source>In the controller</source>
        <translation>In der Steuerung</translation>
    </message>
    <message>
        <source>Open on this panel</source>
        <translation>Auf diesem Panel offen</translation>
    </message>
    <message>
        <source>Stored on this panel</source>
        <translation>Auf diesem Panel gespeichert</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Copy …</source>
        <translation>Kopieren …</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Löschen …</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Download …</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Codes …</source>
        <translation>Codes …</translation>
    </message>
    <message>
        <source>In the controller and open here</source>
        <translation>In der Steuerung und hier offen</translation>
    </message>
    <message>
        <source>Approved …</source>
        <translation>Freigaben …</translation>
    </message>
</context>
<context>
    <name>RecipeComparisonSheet</name>
    <message>
        <source>Versions of %1</source>
        <translation>Versionen von %1</translation>
    </message>
    <message>
        <source>Compare %1</source>
        <translation>%1 vergleichen</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>To newest</source>
        <translation>Mit neuester</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>Keine Unterschiede</translation>
    </message>
    <message>
        <source>There is no other version to compare.</source>
        <translation>Es gibt keine andere Version zum Vergleichen.</translation>
    </message>
    <message>
        <source>Choose an entry at the left.</source>
        <translation>Links einen Eintrag wählen.</translation>
    </message>
    <message>
        <source>This is the newest version.</source>
        <translation>Dies ist die neueste Version.</translation>
    </message>
    <message>
        <source>This is the first version.</source>
        <translation>Dies ist die erste Version.</translation>
    </message>
    <message>
        <source>Open this version</source>
        <translation>Diese Version öffnen</translation>
    </message>
</context>
<context>
    <name>RecipeRow</name>
    <message>
        <source>v%1 · %2</source>
        <translation>v%1 · %2</translation>
    </message>
    <message>
        <source>Open on this panel</source>
        <translation>Auf diesem Panel offen</translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation>In der Steuerung</translation>
    </message>
    <message>
        <source>In the controller and open here</source>
        <translation>In der Steuerung und hier offen</translation>
    </message>
</context>
<context>
    <name>RecipesPage</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>all %1 recipes</source>
        <translation>alle %1 Rezepte</translation>
    </message>
    <message>
        <source>End the search</source>
        <translation>Suche beenden</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Neu …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Import …</translation>
    </message>
    <message>
        <source>Export all …</source>
        <translation>Alle exportieren …</translation>
    </message>
    <message>
        <source>%1 was edited and is not saved.</source>
        <translation>%1 wurde bearbeitet und ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Rückspielen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern als …</translation>
    </message>
    <message>
        <source>Save as version %1</source>
        <translation>Als Version %1 speichern</translation>
    </message>
    <message>
        <source>Reading the recipes …</source>
        <translation>Rezepte werden gelesen …</translation>
    </message>
    <message>
        <source>No recipe name contains &quot;%1&quot;. Change or clear the search.</source>
        <translation>Kein Rezeptname enthält „%1“. Suche ändern oder löschen.</translation>
    </message>
    <message>
        <source>There is no recipe yet. Create a recipe, or import one from a USB stick.</source>
        <translation>Noch kein Rezept. Ein Rezept anlegen oder von einem USB-Stick importieren.</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>1 recipe</source>
        <translation>1 Rezept</translation>
    </message>
    <message>
        <source>A new recipe of this kind, with the data of this machine</source>
        <translation>Ein neues Rezept dieser Art, mit den Daten dieser Maschine</translation>
    </message>
    <message>
        <source>Name of the new recipe</source>
        <translation>Name des neuen Rezepts</translation>
    </message>
    <message>
        <source>Name of the copy</source>
        <translation>Name der Kopie</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>New name of %1</source>
        <translation>Neuer Name von %1</translation>
    </message>
    <message>
        <source>Export as JSON</source>
        <translation>Als JSON exportieren</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>%1 löschen?</translation>
    </message>
    <message>
        <source>The recipe leaves the list; its versions are kept. Saving a recipe under this name restores them.</source>
        <translation>Das Rezept verlässt die Liste; seine Versionen bleiben. Ein Speichern unter diesem Namen stellt sie wieder her.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 ist nicht gespeichert</translation>
    </message>
    <message>
        <source>The recipe was edited. Opening another recipe without saving discards the edits.</source>
        <translation>Das Rezept wurde bearbeitet. Ein anderes zu öffnen, ohne zu speichern, verwirft die Änderungen.</translation>
    </message>
    <message>
        <source>Discard edits</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>There is no recipe file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.</source>
        <translation>Keine Rezeptdatei auf einem USB-Stick oder in %1. Stick einstecken; das Panel findet sie selbsttätig.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>View …</source>
        <translation>Ansehen …</translation>
    </message>
    <message>
        <source>Import recipes</source>
        <translation>Rezepte importieren</translation>
    </message>
    <message>
        <source>Import all %1</source>
        <translation>Alle %1 importieren</translation>
    </message>
    <message>
        <source>%1 is not saved yet.</source>
        <translation>%1 ist noch nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>RegimeSheet</name>
    <message>
        <source>Regime map</source>
        <translation>Kennfeld</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
    <message>
        <source>reference lengths</source>
        <translation>Bezugslängen</translation>
    </message>
    <message>
        <source>Drag the dot to another length and rate.</source>
        <translation>Den Punkt auf eine andere Länge und Taktzahl ziehen.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>RegisterRow</name>
    <message>
        <source>%1 · can be written</source>
        <translation>%1 · beschreibbar</translation>
    </message>
</context>
<context>
    <name>RegistersSection</name>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Name contains</source>
        <translation>Name enthält</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>No register name contains this text.</source>
        <translation>Kein Registername enthält diesen Text.</translation>
    </message>
    <message>
        <source>Write …</source>
        <translation>Schreiben …</translation>
    </message>
    <message>
        <source>Group of registers</source>
        <translation>Gruppe von Registern</translation>
    </message>
    <message>
        <source>%1 registers</source>
        <translation>%1 Register</translation>
    </message>
    <message>
        <source>Clear the filter</source>
        <translation>Filter löschen</translation>
    </message>
</context>
<context>
    <name>ReportFilesSheet</name>
    <message>
        <source>Choose the location of the new files.</source>
        <translation>Ort der neuen Dateien wählen.</translation>
    </message>
    <message>
        <source>Write file</source>
        <translation>Datei schreiben</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
</context>
<context>
    <name>RunAxis</name>
    <message>
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Master speed</source>
        <translation>Leitgeschw.</translation>
    </message>
    <message>
        <source>Axis speed %1</source>
        <translation>Achsgeschw. %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschw.</translation>
    </message>
    <message>
        <source>Position (%1/cycle)</source>
        <translation>Position (%1/Zyklus)</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Zyklen</translation>
    </message>
</context>
<context>
    <name>RunCutter</name>
    <message>
        <source>bags/min</source>
        <translation>Beutel/min</translation>
    </message>
    <message>
        <source>Knife speed %1</source>
        <translation>Messergeschw. %1</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Taktzahl</translation>
    </message>
    <message>
        <source>seal %1</source>
        <translation>Siegeln %1</translation>
    </message>
    <message>
        <source>Bags</source>
        <translation>Beutel</translation>
    </message>
    <message>
        <source>Rate of the line</source>
        <translation>Taktzahl der Linie</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
</context>
<context>
    <name>RunEmpty</name>
    <message>
        <source>Open Motion</source>
        <translation>Bewegung öffnen</translation>
    </message>
    <message>
        <source>Download %1, edited</source>
        <translation>%1 laden, bearbeitet</translation>
    </message>
    <message>
        <source>Download %1 v%2</source>
        <translation>%1 v%2 laden</translation>
    </message>
    <message>
        <source>Download %1</source>
        <translation>%1 laden</translation>
    </message>
</context>
<context>
    <name>RunPacking</name>
    <message>
        <source>moved</source>
        <translation>verstellt</translation>
    </message>
    <message>
        <source>Cut, product and length</source>
        <translation>Schnitt, Produkt und Länge</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>RunPress</name>
    <message>
        <source>Good / last strokes</source>
        <translation>Gute / letzte Hübe</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
</context>
<context>
    <name>ScannedEditsSheet</name>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 ist nicht gespeichert</translation>
    </message>
    <message>
        <source>The recipe was edited. Opening the scanned recipe %1 without saving discards the edits.</source>
        <translation>Das Rezept wurde bearbeitet. Das gescannte Rezept %1 ohne Speichern zu öffnen verwirft die Änderungen.</translation>
    </message>
    <message>
        <source>Discard edits</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Save as version %1</source>
        <translation>Als Version %1 speichern</translation>
    </message>
</context>
<context>
    <name>ScannerSection</name>
    <message>
        <source>Prefix</source>
        <translation>Präfix</translation>
    </message>
    <message>
        <source>no scanner</source>
        <translation>kein Scanner</translation>
    </message>
    <message>
        <source>Last code</source>
        <translation>Letzter Code</translation>
    </message>
    <message>
        <source>Scan a code to test the scanner. While this section is open, a code opens no recipe.</source>
        <translation>Einen Code scannen, um den Scanner zu prüfen. Solange dieser Abschnitt offen ist, öffnet ein Code kein Rezept.</translation>
    </message>
    <message>
        <source>Set the scanner to send a prefix that nobody types before each code, such as ~~, and enter the same prefix here.</source>
        <translation>Den Scanner so einstellen, dass er vor jedem Code ein Präfix sendet, das niemand tippt, etwa ~~, und hier dasselbe eingeben.</translation>
    </message>
    <message>
        <source>Prefix of the scanner</source>
        <translation>Präfix des Scanners</translation>
    </message>
    <message>
        <source>Suffix of the scanner</source>
        <translation>Suffix des Scanners</translation>
    </message>
</context>
<context>
    <name>SearchSheet</name>
    <message>
        <source>Search for a recipe</source>
        <translation>Rezept suchen</translation>
    </message>
    <message>
        <source>1 recipe</source>
        <translation>1 Rezept</translation>
    </message>
    <message>
        <source>%1 recipes</source>
        <translation>%1 Rezepte</translation>
    </message>
</context>
<context>
    <name>SegmentMotionSheet</name>
    <message>
        <source>Motion of segment %1</source>
        <translation>Bewegung von Abschnitt %1</translation>
    </message>
</context>
<context>
    <name>SegmentSheet</name>
    <message>
        <source>%1 · jump at the start</source>
        <translation>%1 · Sprung am Anfang</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Add dwell</source>
        <translation>Rast einfügen</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Make continuous</source>
        <translation>Stetig machen</translation>
    </message>
    <message>
        <source>CSV files</source>
        <translation>CSV-Dateien</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Abschnitt %1</translation>
    </message>
</context>
<context>
    <name>SensorEdgesSheet</name>
    <message>
        <source>Edges of the mark sensor</source>
        <translation>Flanken des Markensensors</translation>
    </message>
    <message>
        <source>The film below the sensor. The newest edge is at the right; swipe for earlier ones.</source>
        <translation>Die Folie unter dem Sensor. Die neueste Flanke ist rechts; wischen zeigt frühere.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>window of an expected mark</source>
        <translation>Fenster einer erwarteten Marke</translation>
    </message>
    <message>
        <source>Newest edge</source>
        <translation>Neueste Flanke</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Last edge that was not taken; edges since then: %1</source>
        <translation>Letzte nicht übernommene Flanke; Flanken seitdem: %1</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>simulated or serial port</source>
        <translation>simuliert oder seriell</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>versions, disk, safety</source>
        <translation>Versionen, Festplatte, Sicherheit</translation>
    </message>
    <message>
        <source>drive, gear, motor limits</source>
        <translation>Antrieb, Getriebe, Motorgrenzen</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>PINs, levels, audit</source>
        <translation>PINs, Stufen, Protokoll</translation>
    </message>
    <message>
        <source>language, units, theme</source>
        <translation>Sprache, Einheiten, Farben</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Not confirmed yet. Close again to discard the entry.</source>
        <translation>Nicht bestätigt. Zum Verwerfen noch einmal schließen.</translation>
    </message>
</context>
<context>
    <name>ShelvedList</name>
    <message>
        <source>%1 · %2 · by %3</source>
        <translation>%1 · %2 · von %3</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>No alarm is shelved. To shelve a known warning for some hours, tap the warning in the list.</source>
        <translation>Kein Alarm ist zurückgestellt. Um eine bekannte Warnung einige Stunden zurückzustellen, sie in der Liste antippen.</translation>
    </message>
</context>
<context>
    <name>ShiftsSheet</name>
    <message>
        <source>Shifts</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>A shift lasts until the next one starts. It belongs to the day on which it starts.</source>
        <translation>Eine Schicht dauert bis zum Beginn der nächsten. Sie gehört zu dem Tag, an dem sie beginnt.</translation>
    </message>
    <message>
        <source>− 1 h</source>
        <translation>− 1 h</translation>
    </message>
    <message>
        <source>+ 1 h</source>
        <translation>+ 1 h</translation>
    </message>
    <message>
        <source>− 15 min</source>
        <translation>− 15 min</translation>
    </message>
    <message>
        <source>+ 15 min</source>
        <translation>+ 15 min</translation>
    </message>
    <message>
        <source>Add a shift</source>
        <translation>Schicht hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Working days</source>
        <translation>Arbeitstage</translation>
    </message>
</context>
<context>
    <name>SimulatedFaultsSection</name>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Sometimes</source>
        <translation>Manchmal</translation>
    </message>
    <message>
        <source>Often</source>
        <translation>Oft</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
</context>
<context>
    <name>SkippedCutsCard</name>
    <message>
        <source>Skipped cuts</source>
        <translation>Ausgelassene Schnitte</translation>
    </message>
    <message>
        <source>Last: %1</source>
        <translation>Zuletzt: %1</translation>
    </message>
</context>
<context>
    <name>SpeedCard</name>
    <message>
        <source>following error %1</source>
        <translation>Schleppfehler %1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Soll</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
</context>
<context>
    <name>SpeedSheet</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Of the program&apos;s rate. A slower machine seals longer.</source>
        <translation>Von der Leistung des Programms. Eine langsamere Maschine siegelt länger.</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
</context>
<context>
    <name>StartSheet</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start runs %1. Download %2 instead?</source>
        <translation>Start fährt %1. Stattdessen %2 laden?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Start %1</source>
        <translation>%1 starten</translation>
    </message>
</context>
<context>
    <name>StateBar</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Steht</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbetrieb</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
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
        <translation>Grund des Stillstands</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>No stop in this shift.</source>
        <translation>Kein Stillstand in dieser Schicht.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
</context>
<context>
    <name>StopQuestion</name>
    <message>
        <source>Why is the machine stopped?</source>
        <translation>Warum steht die Maschine?</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
</context>
<context>
    <name>StopsPage</name>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Trends</source>
        <translation>Trends</translation>
    </message>
    <message>
        <source>Stops: %1</source>
        <translation>Stillstände: %1</translation>
    </message>
    <message>
        <source>%1 without a reason</source>
        <translation>%1 ohne Grund</translation>
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
        <translation>In dieser Schicht wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>Stops as CSV</source>
        <translation>Stillstände als CSV</translation>
    </message>
    <message>
        <source>Shift report as PDF</source>
        <translation>Schichtbericht als PDF</translation>
    </message>
    <message>
        <source>Previous shift</source>
        <translation>Vorige Schicht</translation>
    </message>
    <message>
        <source>Next shift</source>
        <translation>Nächste Schicht</translation>
    </message>
</context>
<context>
    <name>StopsSection</name>
    <message>
        <source>Stops and shifts</source>
        <translation>Stillstände und Schichten</translation>
    </message>
    <message>
        <source>Shifts start at</source>
        <translation>Schichten beginnen um</translation>
    </message>
    <message>
        <source>Working days</source>
        <translation>Arbeitstage</translation>
    </message>
    <message>
        <source>Reasons of a stop</source>
        <translation>Stillstandsgründe</translation>
    </message>
    <message>
        <source>Name of the reason</source>
        <translation>Name des Grundes</translation>
    </message>
    <message>
        <source>Standard list</source>
        <translation>Standardliste</translation>
    </message>
    <message>
        <source>Replace the own list by the standard list? Stops keep their reasons.</source>
        <translation>Die eigene Liste durch die Standardliste ersetzen? Stillstände behalten ihre Gründe.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Ideal rate (0: by recipe)</source>
        <translation>Ideale Taktrate (0: laut Rezept)</translation>
    </message>
</context>
<context>
    <name>StrokeCard</name>
    <message>
        <source>Stroke</source>
        <translation>Hub</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>Kraft N</translation>
    </message>
    <message>
        <source>Completed strokes are listed here.</source>
        <translation>Abgeschlossene Hübe stehen hier.</translation>
    </message>
</context>
<context>
    <name>SystemSection</name>
    <message>
        <source>Screen and system</source>
        <translation>Bildschirm und System</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Network port</source>
        <translation>Netzwerkanschluss</translation>
    </message>
    <message>
        <source>The brightness of this screen cannot be set here.</source>
        <translation>Die Helligkeit dieses Bildschirms ist hier nicht einstellbar.</translation>
    </message>
    <message>
        <source>Screen rotation</source>
        <translation>Bildschirmdrehung</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Touchscreen</source>
        <translation>Touchscreen</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>touch four crosses; the panel restarts</source>
        <translation>vier Kreuze berühren; das Panel startet neu</translation>
    </message>
    <message>
        <source>Remove calibration</source>
        <translation>Kalibrierung entfernen</translation>
    </message>
    <message>
        <source>as before the first one; the panel restarts</source>
        <translation>wie vor der ersten; das Panel startet neu</translation>
    </message>
    <message>
        <source>Clean the screen</source>
        <translation>Reinigen</translation>
    </message>
    <message>
        <source>30 s without touch</source>
        <translation>30 s ohne Berührung</translation>
    </message>
</context>
<context>
    <name>TextKeyboard</name>
    <message>
        <source>-</source>
        <extracomment>The letters of the language beyond a to z, small and capital, at most 27; - for none.</extracomment>
        <translation>äöüßÄÖÜ</translation>
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
        <translation>Leer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Capital letters</source>
        <translation>Großbuchstaben</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>Program unknown</source>
        <translation>Programm unbekannt</translation>
    </message>
    <message>
        <source>open: %1</source>
        <translation>offen: %1</translation>
    </message>
</context>
<context>
    <name>TouchCrosses</name>
    <message>
        <source>Touch the center of the cross.</source>
        <translation>Die Mitte des Kreuzes berühren.</translation>
    </message>
    <message>
        <source>Cross %1 of %2</source>
        <translation>Kreuz %1 von %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>TowerSection</name>
    <message>
        <source>Light tower and horn</source>
        <translation>Signalsäule und Hupe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>TrendCard</name>
    <message>
        <source>Trend curves</source>
        <translation>Trendkurven</translation>
    </message>
    <message>
        <source>no data in this time</source>
        <translation>keine Daten in dieser Zeit</translation>
    </message>
    <message>
        <source>n %1 · mean %2 · std dev %3 · %4 … %5 · %6 % within</source>
        <translation>n %1 · Mittel %2 · Std.-abw. %3 · %4 … %5 · %6 % innerhalb</translation>
    </message>
    <message>
        <source>n %1 · mean %2 · std dev %3 · %4 … %5</source>
        <translation>n %1 · Mittel %2 · Std.-abw. %3 · %4 … %5</translation>
    </message>
    <message>
        <source>%1 · no data</source>
        <translation>%1 · keine Daten</translation>
    </message>
    <message>
        <source>%1 · mean %2 · %3 … %4</source>
        <translation>%1 · Mittel %2 · %3 … %4</translation>
    </message>
    <message>
        <source>There are no data in this time. Press Now, or − for a longer time.</source>
        <translation>Keine Daten in dieser Zeit. Jetzt drücken, oder − für eine längere Zeit.</translation>
    </message>
</context>
<context>
    <name>TrendCurvesSheet</name>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Up to three curves; one more replaces the lowest.</source>
        <translation>Bis zu drei Kurven; eine weitere ersetzt die unterste.</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Bag length %1</source>
        <translation>Beutellänge %1</translation>
    </message>
    <message>
        <source>Deviation %1</source>
        <translation>Abweichung %1</translation>
    </message>
    <message>
        <source>Mark error %1</source>
        <translation>Markenfehler %1</translation>
    </message>
    <message>
        <source>Following error %1</source>
        <translation>Schleppfehler %1</translation>
    </message>
    <message>
        <source>Rate bags/min</source>
        <translation>Taktzahl Beutel/min</translation>
    </message>
    <message>
        <source>Response time ms</source>
        <translation>Antwortzeit ms</translation>
    </message>
    <message>
        <source>each bag, per bag length</source>
        <translation>jeder Beutel, je Beutellänge</translation>
    </message>
    <message>
        <source>each bag against the set length</source>
        <translation>jeder Beutel gegen die Solllänge</translation>
    </message>
    <message>
        <source>each cut against its printed mark</source>
        <translation>jeder Schnitt gegen seine Druckmarke</translation>
    </message>
    <message>
        <source>knife, while turning</source>
        <translation>Messer, während es dreht</translation>
    </message>
    <message>
        <source>master, 0 at standstill</source>
        <translation>Leitachse, 0 im Stillstand</translation>
    </message>
    <message>
        <source>controller to the panel&apos;s requests</source>
        <translation>Steuerung auf Anfragen des Panels</translation>
    </message>
    <message>
        <source>Residue %</source>
        <translation>Rückstand %</translation>
    </message>
    <message>
        <source>torque at the cut, 1000 bags</source>
        <translation>Moment am Schnitt, 1000 Beutel</translation>
    </message>
</context>
<context>
    <name>TrendsPage</name>
    <message>
        <source>%1
clock not set</source>
        <comment>from, to</comment>
        <translation>%1
Uhr nicht gestellt</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>1 h</source>
        <translation>1 h</translation>
    </message>
    <message>
        <source>8 h</source>
        <translation>8 h</translation>
    </message>
    <message>
        <source>1 day</source>
        <translation>1 Tag</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 Tage</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
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
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Bags and trends as CSV</source>
        <translation>Beutel und Trends als CSV</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
</context>
<context>
    <name>TrialCover</name>
    <message>
        <source>Keep this rotation?</source>
        <translation>Diese Drehung behalten?</translation>
    </message>
    <message>
        <source>Without an answer the earlier one returns in %1 s.</source>
        <translation>Ohne Antwort gilt in %1 s wieder die frühere.</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep this calibration of the touchscreen?</source>
        <translation>Diese Kalibrierung des Touchscreens behalten?</translation>
    </message>
</context>
<context>
    <name>TrimSheet</name>
    <message>
        <source>The next bags follow. Each touch moves by %1; hold a key to repeat.</source>
        <translation>Die nächsten Beutel folgen. Jede Berührung verstellt um %1; Taste halten, um zu wiederholen.</translation>
    </message>
    <message>
        <source>Save with recipe</source>
        <translation>Im Rezept speichern</translation>
    </message>
    <message>
        <source>%1 back to 0</source>
        <translation>%1 zurück auf 0</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>One bag</source>
        <translation>Ein Beutel</translation>
    </message>
    <message>
        <source>Single cut</source>
        <translation>Einzelschnitt</translation>
    </message>
    <message>
        <source>Next bag to me</source>
        <translation>Nächster Beutel zu mir</translation>
    </message>
    <message>
        <source>The next bags follow. Not saved with the recipe.</source>
        <translation>Die nächsten Beutel folgen. Nicht mit dem Rezept gespeichert.</translation>
    </message>
</context>
<context>
    <name>UpdateSheet</name>
    <message>
        <source>Installed: CamPanel %1</source>
        <translation>Installiert: CamPanel %1</translation>
    </message>
    <message>
        <source>Choose a version.</source>
        <translation>Wählen Sie eine Version.</translation>
    </message>
    <message>
        <source>There is no package of CamPanel on a USB stick. Plug a stick in; the panel finds it automatically.</source>
        <translation>Auf keinem USB-Stick ist ein Paket von CamPanel. Stecken Sie einen Stick ein; das Panel findet ihn selbst.</translation>
    </message>
    <message>
        <source>The version before the last update is kept on this panel.</source>
        <translation>Die Version vor der letzten Aktualisierung ist auf diesem Panel vorhanden.</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisierung</translation>
    </message>
</context>
<context>
    <name>UserSheet</name>
    <message>
        <source>Yes, remove</source>
        <translation>Ja, entfernen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Neue PIN</translation>
    </message>
</context>
<context>
    <name>UsersSection</name>
    <message>
        <source>Users</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>No PIN is set: all users have full access until the first user is added. Viewing and Stop never need a login.</source>
        <translation>Keine PIN gesetzt: alle Benutzer dürfen alles, bis der erste angelegt ist. Ansehen und Stopp gehen immer ohne Anmeldung.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Nobody logged in · %1</source>
        <translation>Niemand angemeldet · %1</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Add a user</source>
        <translation>Benutzer anlegen</translation>
    </message>
    <message>
        <source>view and stop</source>
        <translation>ansehen und stoppen</translation>
    </message>
    <message>
        <source>operate</source>
        <translation>bedienen</translation>
    </message>
    <message>
        <source>Record of changes</source>
        <translation>Änderungsprotokoll</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Neue PIN</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>View and stop</source>
        <translation>Ansehen und stoppen</translation>
    </message>
    <message>
        <source>operators must log in</source>
        <translation>Bediener müssen sich anmelden</translation>
    </message>
    <message>
        <source>First user</source>
        <translation>Erster Benutzer</translation>
    </message>
    <message>
        <source>Logout without touch after</source>
        <translation>Abmeldung ohne Berührung nach</translation>
    </message>
    <message>
        <source>Row or register</source>
        <translation>Zeile oder Register</translation>
    </message>
</context>
<context>
    <name>VerdictBar</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>VersionsSection</name>
    <message>
        <source>Versions and disk</source>
        <translation>Versionen und Festplatte</translation>
    </message>
</context>
<context>
    <name>WindowLine</name>
    <message>
        <source>Give a reason …</source>
        <translation>Grund angeben …</translation>
    </message>
</context>
<context>
    <name>WindowReasonSheet</name>
    <message>
        <source>Why outside the approved window?</source>
        <translation>Warum außerhalb des freigegebenen Bereichs?</translation>
    </message>
    <message>
        <source>The reason is shown until the machine runs within the window again, and kept in the audit trail.</source>
        <translation>Der Grund wird angezeigt, bis die Maschine wieder im freigegebenen Bereich läuft, und steht im Änderungsprotokoll.</translation>
    </message>
    <message>
        <source>Film or product differs</source>
        <translation>Folie oder Produkt weicht ab</translation>
    </message>
    <message>
        <source>Adapted to the line before or after</source>
        <translation>An die Linie davor oder danach angepasst</translation>
    </message>
    <message>
        <source>Trial, approved by word</source>
        <translation>Versuch, mündlich freigegeben</translation>
    </message>
    <message>
        <source>Another reason …</source>
        <translation>Anderer Grund …</translation>
    </message>
</context>
<context>
    <name>WindowReasonText</name>
    <message>
        <source>Why outside the approved window?</source>
        <translation>Warum außerhalb des freigegebenen Bereichs?</translation>
    </message>
</context>
<context>
    <name>WindowsSheet</name>
    <message>
        <source>Approved values of %1</source>
        <translation>Freigegebene Werte von %1</translation>
    </message>
    <message>
        <source>A value outside needs a reason. The limits of the machine stay.</source>
        <translation>Ein Wert außerhalb braucht einen Grund. Die Grenzen der Maschine bleiben.</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>No window for %1</source>
        <translation>Kein freigegebener Bereich für %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>ZonePicker</name>
    <message>
        <source>Time zone</source>
        <translation>Zeitzone</translation>
    </message>
</context>
</TS>
