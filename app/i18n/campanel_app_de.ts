<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>AccessSentences</name>
    <message>
        <source>View only</source>
        <translation>Nur ansehen</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Techniker</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Service</translation>
    </message>
    <message>
        <source>view everything, stop the machine</source>
        <translation>alles ansehen, Maschine stoppen</translation>
    </message>
    <message>
        <source>start, bag length, rate, recipes, alarms</source>
        <translation>Start, Beutellänge, Takt, Rezepte, Alarme</translation>
    </message>
    <message>
        <source>plus cam, machine, packing, connection</source>
        <translation>dazu Kurve, Maschine, Packung, Verbindung</translation>
    </message>
    <message>
        <source>plus users and single registers</source>
        <translation>dazu Benutzer und einzelne Register</translation>
    </message>
    <message>
        <source>Log in to operate the machine. Stop needs no login.</source>
        <translation>Anmelden, um die Maschine zu bedienen. Stopp geht ohne Anmeldung.</translation>
    </message>
    <message>
        <source>This requires the level Technician or Service. Users with this level:</source>
        <translation>Erfordert die Stufe Techniker oder Service. Benutzer mit dieser Stufe:</translation>
    </message>
    <message>
        <source>This requires the level Service. Users with this level:</source>
        <translation>Erfordert die Stufe Service. Benutzer mit dieser Stufe:</translation>
    </message>
    <message>
        <source>A PIN has %1 to %2 digits.</source>
        <translation>Eine PIN hat %1 bis %2 Ziffern.</translation>
    </message>
    <message>
        <source>A PIN of equal digits is easy to guess. Choose another PIN.</source>
        <translation>Gleiche Ziffern sind leicht zu erraten. Andere PIN wählen.</translation>
    </message>
    <message>
        <source>Sequences such as 1234 are easy to guess. Choose another PIN.</source>
        <translation>Folgen wie 1234 sind leicht zu erraten. Andere PIN wählen.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1.</source>
        <translation>Falsche PIN. Nächster Versuch in %1.</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again.</source>
        <translation>Falsche PIN. Noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Locked after wrong PINs. Try again in %1.</source>
        <translation>Nach falschen PINs gesperrt. Nächster Versuch in %1.</translation>
    </message>
    <message>
        <source>%1 Until then PINs cannot be checked: only operators can work.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1 Bis dahin können PINs nicht geprüft werden: nur Bediener können arbeiten.</translation>
    </message>
    <message>
        <source>A PIN of the level Service has %1 to %2 digits.</source>
        <translation>Eine PIN der Stufe Service hat %1 bis %2 Ziffern.</translation>
    </message>
</context>
<context>
    <name>AlarmCatalogue</name>
    <message>
        <source>%1 %2</source>
        <comment>whole sentences: cause and what to do</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Following error too large</source>
        <translation>Schleppfehler zu groß</translation>
    </message>
    <message>
        <source>The axis cannot follow its setpoint.</source>
        <translation>Die Achse kann ihrem Sollwert nicht folgen.</translation>
    </message>
    <message>
        <source>Check for a jam, reset the fault, then start the reference run.</source>
        <translation>Auf Verklemmung prüfen, Störung quittieren, Referenzfahrt starten.</translation>
    </message>
    <message>
        <source>Table damaged</source>
        <translation>Tabelle beschädigt</translation>
    </message>
    <message>
        <source>The table in the controller is damaged.</source>
        <translation>Die Tabelle in der Steuerung ist beschädigt.</translation>
    </message>
    <message>
        <source>Reset the fault and download the recipe again.</source>
        <translation>Störung quittieren und das Rezept erneut laden.</translation>
    </message>
    <message>
        <source>No index mark</source>
        <translation>Keine Nullmarke</translation>
    </message>
    <message>
        <source>No index mark was found in the reference run.</source>
        <translation>Bei der Referenzfahrt wurde keine Nullmarke gefunden.</translation>
    </message>
    <message>
        <source>Check drive and index sensor, then reset the fault.</source>
        <translation>Antrieb und Nullmarkensensor prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Max. force reached</source>
        <translation>Max. Kraft erreicht</translation>
    </message>
    <message>
        <source>The press reached the maximum force, stopped and returned.</source>
        <translation>Die Presse hat die maximale Kraft erreicht, angehalten und ist zurückgefahren.</translation>
    </message>
    <message>
        <source>Check for a jam or a wrong workpiece, then reset the fault.</source>
        <translation>Auf Verklemmung oder falsches Werkstück prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Contact too early</source>
        <translation>Kontakt zu früh</translation>
    </message>
    <message>
        <source>The press touched an object during the approach.</source>
        <translation>Die Presse hat beim Anfahren einen Gegenstand berührt.</translation>
    </message>
    <message>
        <source>Check the workpiece and the approach position, then reset the fault.</source>
        <translation>Werkstück und Anfahrposition prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>No workpiece</source>
        <translation>Kein Werkstück</translation>
    </message>
    <message>
        <source>The press did not detect a workpiece.</source>
        <translation>Die Presse hat kein Werkstück erkannt.</translation>
    </message>
    <message>
        <source>Insert a workpiece or check the probe position, then reset the fault.</source>
        <translation>Werkstück einlegen oder Tastposition prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Master too fast</source>
        <translation>Leitachse zu schnell</translation>
    </message>
    <message>
        <source>The axis cannot follow the master: the pulse frequency is too high.</source>
        <translation>Die Achse kann der Leitachse nicht folgen: die Pulsfrequenz ist zu hoch.</translation>
    </message>
    <message>
        <source>Lower the master speed, then reset the fault.</source>
        <translation>Leitgeschwindigkeit senken, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Drive alarm</source>
        <translation>Alarm des Antriebs</translation>
    </message>
    <message>
        <source>The drive of the axis reports an alarm.</source>
        <translation>Der Antrieb der Achse meldet einen Alarm.</translation>
    </message>
    <message>
        <source>Read the code on the drive and remove its cause, then reset the fault.</source>
        <translation>Code am Antrieb ablesen, Ursache beseitigen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Unknown fault</source>
        <translation>Unbekannte Störung</translation>
    </message>
    <message>
        <source>The controller reports a fault that this panel does not know.</source>
        <translation>Die Steuerung meldet eine Störung, die dieses Panel nicht kennt.</translation>
    </message>
    <message>
        <source>Update the panel. Until then check the machine before you reset the fault.</source>
        <translation>Panel aktualisieren. Bis dahin vor dem Quittieren die Maschine prüfen.</translation>
    </message>
    <message>
        <source>No panel heartbeat</source>
        <translation>Kein Lebenszeichen</translation>
    </message>
    <message>
        <source>The controller received no heartbeat from the panel for some time.</source>
        <translation>Die Steuerung hat einige Zeit kein Lebenszeichen vom Panel erhalten.</translation>
    </message>
    <message>
        <source>Check the cable.</source>
        <translation>Kabel prüfen.</translation>
    </message>
    <message>
        <source>Not referenced</source>
        <translation>Nicht referenziert</translation>
    </message>
    <message>
        <source>The controller does not know the position of the axis.</source>
        <translation>Die Steuerung kennt die Position der Achse nicht.</translation>
    </message>
    <message>
        <source>No action required: Start begins with the reference run.</source>
        <translation>Nichts zu tun: Start führt zuerst die Referenzfahrt aus.</translation>
    </message>
    <message>
        <source>Saved copy damaged</source>
        <translation>Gespeicherte Kopie beschädigt</translation>
    </message>
    <message>
        <source>One of the two saved copies in the controller is damaged.</source>
        <translation>Eine der zwei gespeicherten Kopien in der Steuerung ist beschädigt.</translation>
    </message>
    <message>
        <source>Save the program again.</source>
        <translation>Programm erneut speichern.</translation>
    </message>
    <message>
        <source>Clock not set</source>
        <translation>Uhr nicht gestellt</translation>
    </message>
    <message>
        <source>The controller has had no time of day since power-on.</source>
        <translation>Die Steuerung hat seit dem Einschalten keine Uhrzeit.</translation>
    </message>
    <message>
        <source>No action required: the panel sets the clock when it connects.</source>
        <translation>Nichts zu tun: das Panel stellt die Uhr beim Verbinden.</translation>
    </message>
    <message>
        <source>Emergency stop pressed</source>
        <translation>Not-Halt betätigt</translation>
    </message>
    <message>
        <source>The emergency stop of the machine is pressed.</source>
        <translation>Der Not-Halt der Maschine ist betätigt.</translation>
    </message>
    <message>
        <source>Make sure that the machine is safe, then release the emergency stop.</source>
        <translation>Sicherstellen, dass die Maschine sicher ist, dann Not-Halt entriegeln.</translation>
    </message>
    <message>
        <source>Unknown warning</source>
        <translation>Unbekannte Warnung</translation>
    </message>
    <message>
        <source>The controller reports a warning that this panel does not know.</source>
        <translation>Die Steuerung meldet eine Warnung, die dieses Panel nicht kennt.</translation>
    </message>
    <message>
        <source>Update the panel.</source>
        <translation>Panel aktualisieren.</translation>
    </message>
    <message>
        <source>Marks lost</source>
        <translation>Druckmarken verloren</translation>
    </message>
    <message>
        <source>The controller lost the marks on the film and stopped the run.</source>
        <translation>Die Steuerung hat die Druckmarken der Folie verloren und den Lauf gestoppt.</translation>
    </message>
    <message>
        <source>Check film and mark sensor, then start again.</source>
        <translation>Folie und Markensensor prüfen, dann neu starten.</translation>
    </message>
    <message>
        <source>Wrong mark distance</source>
        <translation>Falscher Markenabstand</translation>
    </message>
    <message>
        <source>The mark distance on the film differs from the bag length, so the run was stopped.</source>
        <translation>Der Markenabstand der Folie weicht von der Beutellänge ab; der Lauf wurde gestoppt.</translation>
    </message>
    <message>
        <source>Correction limit reached</source>
        <translation>Korrekturgrenze erreicht</translation>
    </message>
    <message>
        <source>The correction limits were too small to follow the marks, so the run was stopped.</source>
        <translation>Die Korrekturgrenzen waren zu klein, um den Marken zu folgen; der Lauf wurde gestoppt.</translation>
    </message>
    <message>
        <source>Check the film for tension and slip, then start again.</source>
        <translation>Folie auf Spannung und Schlupf prüfen, dann neu starten.</translation>
    </message>
    <message>
        <source>Product too long</source>
        <translation>Produkt zu lang</translation>
    </message>
    <message>
        <source>A product is longer than the bag, so the run was stopped.</source>
        <translation>Ein Produkt ist länger als der Beutel; der Lauf wurde gestoppt.</translation>
    </message>
    <message>
        <source>Remove the product or set a longer bag, then start again.</source>
        <translation>Produkt entfernen oder längeren Beutel einstellen, dann neu starten.</translation>
    </message>
    <message>
        <source>Too many skipped cuts</source>
        <translation>Zu viele Schnitte ausgelassen</translation>
    </message>
    <message>
        <source>Products blocked the knife several times in a row, so the run was stopped.</source>
        <translation>Produkte lagen mehrmals nacheinander unter dem Messer; der Lauf wurde gestoppt.</translation>
    </message>
    <message>
        <source>Align the products, then start again.</source>
        <translation>Produkte ausrichten, dann neu starten.</translation>
    </message>
    <message>
        <source>Port missing</source>
        <translation>Schnittstelle fehlt</translation>
    </message>
    <message>
        <source>The port to the controller does not exist.</source>
        <translation>Die Schnittstelle zur Steuerung ist nicht vorhanden.</translation>
    </message>
    <message>
        <source>Plug the adapter in, or choose another port in the settings.</source>
        <translation>Adapter einstecken oder in den Einstellungen eine andere Schnittstelle wählen.</translation>
    </message>
    <message>
        <source>No response</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>No response on the port to the controller.</source>
        <translation>Keine Antwort an der Schnittstelle zur Steuerung.</translation>
    </message>
    <message>
        <source>Check cable, power, baud rate, parity and unit number.</source>
        <translation>Kabel, Versorgung, Baudrate, Parität und Gerätenummer prüfen.</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>The connection to the controller was interrupted.</source>
        <translation>Die Verbindung zur Steuerung wurde unterbrochen.</translation>
    </message>
    <message>
        <source>Check the cable and the controller&apos;s power; the panel reconnects automatically.</source>
        <translation>Kabel und Versorgung der Steuerung prüfen; das Panel verbindet sich selbsttätig.</translation>
    </message>
    <message>
        <source>Wrong device</source>
        <translation>Falsches Gerät</translation>
    </message>
    <message>
        <source>The device on the port is not a controller that this panel knows.</source>
        <translation>Das Gerät an der Schnittstelle ist keine Steuerung, die dieses Panel kennt.</translation>
    </message>
    <message>
        <source>Choose another port or unit number, or update the older device.</source>
        <translation>Andere Schnittstelle oder Gerätenummer wählen, oder das ältere Gerät aktualisieren.</translation>
    </message>
    <message>
        <source>Port not usable</source>
        <translation>Schnittstelle gesperrt</translation>
    </message>
    <message>
        <source>The port to the controller exists but cannot be used.</source>
        <translation>Die Schnittstelle zur Steuerung ist vorhanden, aber nicht nutzbar.</translation>
    </message>
    <message>
        <source>Close the program that uses the port, or choose another port or other settings.</source>
        <translation>Das Programm schließen, das sie belegt, oder eine andere Schnittstelle oder andere Einstellungen wählen.</translation>
    </message>
    <message>
        <source>Simulated controller missing</source>
        <translation>Simulierte Steuerung fehlt</translation>
    </message>
    <message>
        <source>The simulated controller was not found or has stopped.</source>
        <translation>Die simulierte Steuerung wurde nicht gefunden oder hat angehalten.</translation>
    </message>
    <message>
        <source>Install the simulated controller, or choose a serial port in the settings.</source>
        <translation>Simulierte Steuerung installieren oder in den Einstellungen eine serielle Schnittstelle wählen.</translation>
    </message>
    <message>
        <source>Database replaced by its copy</source>
        <translation>Datenbank durch Kopie ersetzt</translation>
    </message>
    <message>
        <source>Check that the newest recipes are there. If this happens again, replace the disk.</source>
        <translation>Prüfen, ob die neuesten Rezepte da sind. Bei Wiederholung den Datenträger tauschen.</translation>
    </message>
    <message>
        <source>Database lost</source>
        <translation>Datenbank verloren</translation>
    </message>
    <message>
        <source>Restore a backup if there is one. If this happens again, replace the disk.</source>
        <translation>Wenn vorhanden, eine Sicherung zurückspielen. Bei Wiederholung den Datenträger tauschen.</translation>
    </message>
    <message>
        <source>Database not opened</source>
        <translation>Datenbank nicht geöffnet</translation>
    </message>
    <message>
        <source>The panel cannot open its database: new data are lost at a restart.</source>
        <translation>Das Panel kann seine Datenbank nicht öffnen: neue Daten gehen beim Neustart verloren.</translation>
    </message>
    <message>
        <source>Read the detail, remove the cause and restart the panel.</source>
        <translation>Einzelheit lesen, Ursache beseitigen und das Panel neu starten.</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Datenträger voll</translation>
    </message>
    <message>
        <source>The panel&apos;s disk is full: new data are not saved.</source>
        <translation>Der Datenträger des Panels ist voll: neue Daten werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Free some disk space. Data saved before are not lost.</source>
        <translation>Speicherplatz freigeben. Früher gespeicherte Daten sind nicht verloren.</translation>
    </message>
    <message>
        <source>Disk write-protected</source>
        <translation>Datenträger schreibgeschützt</translation>
    </message>
    <message>
        <source>The panel cannot write to its disk: new data are not saved.</source>
        <translation>Das Panel kann nicht auf seinen Datenträger schreiben: neue Daten werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Remove the write protection. If the disk protects itself, replace the disk.</source>
        <translation>Schreibschutz aufheben. Schützt sich der Datenträger selbst, ihn tauschen.</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Some data could not be saved in the panel&apos;s database.</source>
        <translation>Einige Daten konnten nicht in der Datenbank gespeichert werden.</translation>
    </message>
    <message>
        <source>Read the detail and try again. If this happens again, restart the panel.</source>
        <translation>Einzelheit lesen und erneut versuchen. Bei Wiederholung das Panel neu starten.</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>Rezeptdatei</translation>
    </message>
    <message>
        <source>The last recipe could not be read or saved.</source>
        <translation>Das letzte Rezept konnte nicht gelesen oder gespeichert werden.</translation>
    </message>
    <message>
        <source>Read the detail; check the recipe before you download it.</source>
        <translation>Einzelheit lesen; das Rezept vor dem Laden prüfen.</translation>
    </message>
    <message>
        <source>Settings file damaged</source>
        <translation>Einstellungsdatei beschädigt</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing.</source>
        <translation>Die Einstellungsdatei war beschädigt oder fehlte.</translation>
    </message>
    <message>
        <source>Read the detail; check the settings, the connection first.</source>
        <translation>Einzelheit lesen; Einstellungen prüfen, zuerst die Verbindung.</translation>
    </message>
    <message>
        <source>Touchscreen missing</source>
        <translation>Touchscreen fehlt</translation>
    </message>
    <message>
        <source>A touchscreen of this panel was unplugged or has failed.</source>
        <translation>Ein Touchscreen dieses Panels wurde abgezogen oder ist ausgefallen.</translation>
    </message>
    <message>
        <source>Check the cable of the touchscreen. Stop the machine with its own switch.</source>
        <translation>Kabel des Touchscreens prüfen. Die Maschine mit ihrem eigenen Schalter stoppen.</translation>
    </message>
    <message>
        <source>Settings not saved</source>
        <translation>Einstellungen nicht gespeichert</translation>
    </message>
    <message>
        <source>The settings cannot be saved: they are lost when the panel is switched off.</source>
        <translation>Die Einstellungen lassen sich nicht speichern: sie gehen beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Check for a full or write-protected disk.</source>
        <translation>Auf vollen oder schreibgeschützten Datenträger prüfen.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged or missing. The last good copy is used.</source>
        <translation>Die Datenbank war beschädigt oder fehlte. Die letzte gute Kopie wird verwendet.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged or missing and there was no copy. A new, empty database was created.</source>
        <translation>Die Datenbank war beschädigt oder fehlte, und es gab keine Kopie. Eine neue, leere Datenbank wurde angelegt.</translation>
    </message>
    <message>
        <source>Users and PINs lost</source>
        <translation>Benutzer und PINs verloren</translation>
    </message>
    <message>
        <source>The users were lost with the panel&apos;s database: only operators can work.</source>
        <translation>Die Benutzer gingen mit der Datenbank verloren: nur Bediener können arbeiten.</translation>
    </message>
    <message>
        <source>Delete the file named in the detail. Then restore a backup.</source>
        <translation>Die in der Einzelheit genannte Datei löschen. Dann eine Sicherung zurückspielen.</translation>
    </message>
    <message>
        <source>Mark sensor has drifted</source>
        <translation>Markensensor hat sich verändert</translation>
    </message>
    <message>
        <source>The mark sensor&apos;s dead time is not the one entered: cuts move on the print when the speed changes.</source>
        <translation>Die Totzeit des Markensensors ist nicht die eingegebene: Schnitte wandern auf dem Druck, wenn sich die Geschwindigkeit ändert.</translation>
    </message>
    <message>
        <source>Clean and check the sensor. If the alarm stays, take over the learned dead time under Maintenance, Packing.</source>
        <translation>Sensor reinigen und prüfen. Bleibt der Alarm, die gelernte Totzeit unter Wartung, Packung übernehmen.</translation>
    </message>
    <message>
        <source>Products joined</source>
        <translation>Produkte verbunden</translation>
    </message>
    <message>
        <source>Take the products off the infeed, then start again.</source>
        <translation>Produkte vom Einlauf nehmen, dann neu starten.</translation>
    </message>
    <message>
        <source>Jaws closed</source>
        <translation>Backen geschlossen</translation>
    </message>
    <message>
        <source>Open them by hand. The bags on both sides are scrap.</source>
        <translation>Von Hand öffnen. Die Beutel zu beiden Seiten sind Ausschuss.</translation>
    </message>
    <message>
        <source>Two products hang together on the infeed, so the run was stopped.</source>
        <translation>Zwei Produkte hängen am Einlauf zusammen, darum wurde der Lauf beendet.</translation>
    </message>
    <message>
        <source>The jaws have been closed on standing film for too long.</source>
        <translation>Die Backen sind zu lange auf stehender Folie geschlossen.</translation>
    </message>
    <message>
        <source>Load the right film, or measure its marks and tell them from other prints under Maintenance.</source>
        <translation>Richtige Folie einlegen, oder ihre Marken unter Wartung messen und von anderem Druck unterscheiden.</translation>
    </message>
    <message>
        <source>Jam at the jaws</source>
        <translation>Verklemmung an den Backen</translation>
    </message>
    <message>
        <source>Take out what lies between the jaws, then reset the fault and start. The machine goes on from there and rejects two bags.</source>
        <translation>Entfernen, was zwischen den Backen liegt, dann Störung quittieren und starten. Die Maschine läuft von dort weiter und wirft zwei Beutel aus.</translation>
    </message>
    <message>
        <source>Something is under the closing jaws.</source>
        <translation>Etwas liegt unter den schließenden Backen.</translation>
    </message>
    <message>
        <source>Line too fast</source>
        <translation>Linie zu schnell</translation>
    </message>
    <message>
        <source>Slow the line down or download a faster program, then start again.</source>
        <translation>Die Linie verlangsamen oder ein schnelleres Programm laden, dann neu starten.</translation>
    </message>
    <message>
        <source>The line became faster than the program allows, so the run was stopped.</source>
        <translation>Die Linie wurde schneller, als das Programm erlaubt; der Lauf wurde beendet.</translation>
    </message>
    <message>
        <source>Encoder signal disturbed</source>
        <translation>Gebersignal gestört</translation>
    </message>
    <message>
        <source>Check the cable and the shield of the encoder, then reset the fault.</source>
        <translation>Kabel und Schirm des Drehgebers prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Encoder counts lost</source>
        <translation>Geberimpulse verloren</translation>
    </message>
    <message>
        <source>Check the encoder, its coupling and its cable, then reset the fault.</source>
        <translation>Drehgeber, Kupplung und Kabel prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Wheel slips on the film</source>
        <translation>Messrad rutscht auf der Folie</translation>
    </message>
    <message>
        <source>Clean the wheel and press it on the film, then reset the fault.</source>
        <translation>Messrad reinigen und an die Folie drücken, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Impossible encoder speed</source>
        <translation>Unmögliche Geberdrehzahl</translation>
    </message>
    <message>
        <source>Check the encoder and its counts per revolution, then reset the fault.</source>
        <translation>Drehgeber und Impulse je Umdrehung prüfen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>The signal of the encoder that leads the line is disturbed.</source>
        <translation>Das Signal des Drehgebers der Leitachse ist gestört.</translation>
    </message>
    <message>
        <source>The encoder that leads the line has lost or gained counts.</source>
        <translation>Der Drehgeber der Leitachse hat Impulse verloren oder zu viel gezählt.</translation>
    </message>
    <message>
        <source>The wheel of the encoder slips on the film.</source>
        <translation>Das Messrad des Drehgebers rutscht auf der Folie.</translation>
    </message>
    <message>
        <source>The encoder that leads the line reports a speed that no machine has.</source>
        <translation>Der Drehgeber der Leitachse meldet eine Geschwindigkeit, die keine Maschine hat.</translation>
    </message>
    <message>
        <source>Master runs backward</source>
        <translation>Leitachse läuft rückwärts</translation>
    </message>
    <message>
        <source>The master runs backward by more than a cycle.</source>
        <translation>Die Leitachse läuft um mehr als einen Zyklus rückwärts.</translation>
    </message>
    <message>
        <source>Door open</source>
        <translation>Tür offen</translation>
    </message>
    <message>
        <source>Close the door, then start again.</source>
        <translation>Tür schließen, dann neu starten.</translation>
    </message>
    <message>
        <source>Next machine not ready</source>
        <translation>Folgemaschine nicht bereit</translation>
    </message>
    <message>
        <source>Clear the next machine, then start again.</source>
        <translation>Ursache an der Folgemaschine beheben, dann neu starten.</translation>
    </message>
    <message>
        <source>Date coder not ready</source>
        <translation>Datumscodierer nicht bereit</translation>
    </message>
    <message>
        <source>Clear the fault of the date coder or switch it on, then start again.</source>
        <translation>Störung des Datumscodierers beheben oder ihn einschalten, dann neu starten.</translation>
    </message>
    <message>
        <source>A door of the machine is open.</source>
        <translation>Eine Tür der Maschine ist offen.</translation>
    </message>
    <message>
        <source>The machine behind this one is not ready.</source>
        <translation>Die Maschine hinter dieser ist nicht bereit.</translation>
    </message>
    <message>
        <source>The date coder is not ready.</source>
        <translation>Der Datumscodierer ist nicht bereit.</translation>
    </message>
    <message>
        <source>Exchange wires A and B, or change the sign with Reversed counting under Settings, Machine, Master, then reset the fault.</source>
        <translation>Adern A und B tauschen oder unter Einstellungen, Maschine, Leitachse die Zählrichtung umkehren, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>Data disk missing</source>
        <translation>Datenträger fehlt</translation>
    </message>
    <message>
        <source>The disk with the panel&apos;s data cannot be used. Recipes, users and records are missing, and new data are lost at a restart.</source>
        <translation>Der Datenträger mit den Daten des Panels ist nicht nutzbar. Rezepte, Benutzer und Aufzeichnungen fehlen, und neue Daten gehen bei einem Neustart verloren.</translation>
    </message>
    <message>
        <source>Replace the disk and restore a backup.</source>
        <translation>Datenträger tauschen und eine Sicherung zurückspielen.</translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>Alarm of a newer panel version</source>
        <translation>Alarm einer neueren Version</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>Aktiv, quittiert</translation>
    </message>
    <message>
        <source>End unknown, acknowledged</source>
        <translation>Ende unbekannt, quittiert</translation>
    </message>
    <message>
        <source>Cleared, acknowledged</source>
        <translation>Beendet, quittiert</translation>
    </message>
    <message>
        <source>Active, not acknowledged</source>
        <translation>Aktiv, nicht quittiert</translation>
    </message>
    <message>
        <source>End unknown, not acknowledged</source>
        <translation>Ende unbekannt, nicht quittiert</translation>
    </message>
    <message>
        <source>Cleared, not acknowledged</source>
        <translation>Beendet, nicht quittiert</translation>
    </message>
    <message>
        <source>Active, shelved</source>
        <translation>Aktiv, zurückgestellt</translation>
    </message>
    <message>
        <source>End unknown, shelved</source>
        <translation>Ende unbekannt, zurückgestellt</translation>
    </message>
    <message>
        <source>Cleared, shelved</source>
        <translation>Beendet, zurückgestellt</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>End unknown</source>
        <translation>Ende unbekannt</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>clock not set</source>
        <translation>Uhr nicht gestellt</translation>
    </message>
</context>
<context>
    <name>AuditWords</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>%1 (reason %2)</source>
        <comment>refused (reason 7)</comment>
        <translation>%1 (Grund %2)</translation>
    </message>
    <message>
        <source>nobody logged in</source>
        <translation>niemand angemeldet</translation>
    </message>
    <message>
        <source>Row %1 was altered after it was written.</source>
        <translation>Zeile %1 wurde nachträglich verändert.</translation>
    </message>
    <message>
        <source>Row %1 is missing: the audit trail was altered.</source>
        <translation>Zeile %1 fehlt: das Protokoll wurde verändert.</translation>
    </message>
    <message>
        <source>Row %1 and all later rows are missing.</source>
        <translation>Zeile %1 und alle späteren Zeilen fehlen.</translation>
    </message>
    <message>
        <source>Checked: %1 rows, intact.</source>
        <translation>Geprüft: %1 Zeilen, unversehrt.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Wizards</source>
        <translation>Assistenten</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Users and logins</source>
        <translation>Benutzer, Anmeldungen</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Immediate stop</source>
        <translation>Sofortstopp</translation>
    </message>
    <message>
        <source>Reference run</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Fault reset</source>
        <translation>Störung quittiert</translation>
    </message>
    <message>
        <source>Saved in the controller</source>
        <translation>In der Steuerung gespeichert</translation>
    </message>
    <message>
        <source>Marks measured</source>
        <translation>Marken gemessen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Program value</source>
        <translation>Programmwert</translation>
    </message>
    <message>
        <source>Parameter written</source>
        <translation>Parameter geschrieben</translation>
    </message>
    <message>
        <source>Mark sensor measured</source>
        <translation>Markensensor gemessen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldung</translation>
    </message>
    <message>
        <source>Logout</source>
        <translation>Abmeldung</translation>
    </message>
    <message>
        <source>Automatic logout</source>
        <translation>Selbsttätige Abmeldung</translation>
    </message>
    <message>
        <source>User added</source>
        <translation>Benutzer angelegt</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Neue PIN</translation>
    </message>
    <message>
        <source>Level changed</source>
        <translation>Stufe geändert</translation>
    </message>
    <message>
        <source>User removed</source>
        <translation>Benutzer entfernt</translation>
    </message>
    <message>
        <source>Rows lost</source>
        <translation>Zeilen verloren</translation>
    </message>
    <message>
        <source>Oldest rows deleted</source>
        <translation>Älteste Zeilen gelöscht</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>network address</source>
        <translation>Netzwerkadresse</translation>
    </message>
    <message>
        <source>simulated faults</source>
        <translation>simulierte Fehler</translation>
    </message>
    <message>
        <source>done</source>
        <translation>ausgeführt</translation>
    </message>
    <message>
        <source>not sent: no connection</source>
        <translation>nicht gesendet: keine Verbindung</translation>
    </message>
    <message>
        <source>not received by the controller</source>
        <translation>von der Steuerung nicht empfangen</translation>
    </message>
    <message>
        <source>not known: no confirmation</source>
        <translation>nicht bekannt: keine Bestätigung</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>zurückgezogen</translation>
    </message>
    <message>
        <source>canceled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>wrong PIN</source>
        <translation>falsche PIN</translation>
    </message>
    <message>
        <source>locked after wrong PINs</source>
        <translation>nach falschen PINs gesperrt</translation>
    </message>
    <message>
        <source>written, but the cuts still deviate</source>
        <translation>geschrieben, aber die Schnitte weichen noch ab</translation>
    </message>
    <message>
        <source>Backup and restore</source>
        <translation>Sicherung und Rückspielen</translation>
    </message>
    <message>
        <source>Backup created</source>
        <translation>Sicherung angelegt</translation>
    </message>
    <message>
        <source>Replaced by a backup</source>
        <translation>Durch Sicherung ersetzt</translation>
    </message>
    <message>
        <source>Restored from a backup</source>
        <translation>Aus Sicherung zurückgespielt</translation>
    </message>
    <message>
        <source>Reference run ended</source>
        <translation>Referenzfahrt beendet</translation>
    </message>
    <message>
        <source>Jog forward</source>
        <translation>Tippen vorwärts</translation>
    </message>
    <message>
        <source>Jog reverse</source>
        <translation>Tippen rückwärts</translation>
    </message>
    <message>
        <source>Jog ended</source>
        <translation>Tippen beendet</translation>
    </message>
    <message>
        <source>key released</source>
        <translation>Taste losgelassen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>New recipe</source>
        <translation>Neues Rezept</translation>
    </message>
    <message>
        <source>Recipe saved</source>
        <translation>Rezept gespeichert</translation>
    </message>
    <message>
        <source>Recipe renamed</source>
        <translation>Rezept umbenannt</translation>
    </message>
    <message>
        <source>Recipe deleted</source>
        <translation>Rezept gelöscht</translation>
    </message>
    <message>
        <source>Recipe restored</source>
        <translation>Rezept wiederhergestellt</translation>
    </message>
    <message>
        <source>Newest row unknown</source>
        <translation>Neueste Zeile unbekannt</translation>
    </message>
    <message>
        <source>Intact up to row %1. The file with the newest row is missing: later rows may be lost.</source>
        <translation>Unversehrt bis Zeile %1. Die Datei mit der neuesten Zeile fehlt: spätere Zeilen können verloren sein.</translation>
    </message>
    <message>
        <source>Checked: %1 rows, intact; rows may have been lost earlier, see the trail.</source>
        <translation>Geprüft: %1 Zeilen, unversehrt; früher können Zeilen verloren gegangen sein, siehe Protokoll.</translation>
    </message>
    <message>
        <source>Panel database</source>
        <translation>Datenbank des Panels</translation>
    </message>
    <message>
        <source>Replaced by its copy</source>
        <translation>Durch ihre Kopie ersetzt</translation>
    </message>
    <message>
        <source>Lost, new and empty</source>
        <translation>Verloren, neu und leer</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>Command from the network</source>
        <translation>Befehl aus dem Netzwerk</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>Reason of a stop changed</source>
        <translation>Grund eines Stillstands geändert</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>time zone</source>
        <translation>Zeitzone</translation>
    </message>
    <message>
        <source>time server</source>
        <translation>Zeitserver</translation>
    </message>
    <message>
        <source>Film reels</source>
        <translation>Folienrollen</translation>
    </message>
    <message>
        <source>Film reel scanned</source>
        <translation>Folienrolle gescannt</translation>
    </message>
    <message>
        <source>Wrong film reel allowed</source>
        <translation>Falsche Folienrolle zugelassen</translation>
    </message>
    <message>
        <source>Updates</source>
        <translation>Aktualisierungen</translation>
    </message>
    <message>
        <source>Update requested</source>
        <translation>Aktualisierung angefordert</translation>
    </message>
    <message>
        <source>Earlier version requested</source>
        <translation>Frühere Version angefordert</translation>
    </message>
    <message>
        <source>Installation ended</source>
        <translation>Installation beendet</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>angefordert</translation>
    </message>
    <message>
        <source>calibration of the touchscreen</source>
        <translation>Kalibrierung des Touchscreens</translation>
    </message>
    <message>
        <source>Recipe file lost or damaged</source>
        <translation>Rezeptdatei verloren oder beschädigt</translation>
    </message>
    <message>
        <source>Machine data lost or damaged</source>
        <translation>Maschinendaten verloren oder beschädigt</translation>
    </message>
    <message>
        <source>User renamed</source>
        <translation>Benutzer umbenannt</translation>
    </message>
    <message>
        <source>Another version runs</source>
        <translation>Andere Version läuft</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporte</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>Alarm quittiert</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>Alarm zurückgestellt</translation>
    </message>
    <message>
        <source>Alarm unshelved</source>
        <translation>Zurückstellung aufgehoben</translation>
    </message>
    <message>
        <source>Files written</source>
        <translation>Dateien geschrieben</translation>
    </message>
    <message>
        <source>Connection diagnosed</source>
        <translation>Verbindung geprüft</translation>
    </message>
    <message>
        <source>Controller searched for</source>
        <translation>Steuerung gesucht</translation>
    </message>
    <message>
        <source>Statistics reset</source>
        <translation>Statistik zurückgesetzt</translation>
    </message>
    <message>
        <source>Output tried</source>
        <translation>Ausgang getestet</translation>
    </message>
    <message>
        <source>Output try ended</source>
        <translation>Test des Ausgangs beendet</translation>
    </message>
    <message>
        <source>Order started or changed</source>
        <translation>Auftrag begonnen oder geändert</translation>
    </message>
    <message>
        <source>Order ended</source>
        <translation>Auftrag beendet</translation>
    </message>
    <message>
        <source>Speed changed by hand</source>
        <translation>Geschwindigkeit von Hand geändert</translation>
    </message>
    <message>
        <source>Trimmed by hand</source>
        <translation>Von Hand getrimmt</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Order added</source>
        <translation>Auftrag hinzugefügt</translation>
    </message>
    <message>
        <source>Order removed</source>
        <translation>Auftrag entfernt</translation>
    </message>
    <message>
        <source>First bag checked</source>
        <translation>Erster Beutel geprüft</translation>
    </message>
    <message>
        <source>One bag by hand</source>
        <translation>Ein Beutel von Hand</translation>
    </message>
    <message>
        <source>Single cut by hand</source>
        <translation>Einzelschnitt von Hand</translation>
    </message>
    <message>
        <source>Next bag taken</source>
        <translation>Nächster Beutel entnommen</translation>
    </message>
    <message>
        <source>File of the machine builder</source>
        <translation>Datei des Maschinenbauers</translation>
    </message>
    <message>
        <source>Value outside its approved window</source>
        <translation>Wert außerhalb des freigegebenen Bereichs</translation>
    </message>
    <message>
        <source>system</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Axis measured</source>
        <translation>Achse gemessen</translation>
    </message>
    <message>
        <source>Measurement of an axis ended</source>
        <translation>Messung einer Achse beendet</translation>
    </message>
    <message>
        <source>Measured value of an axis taken</source>
        <translation>Messwert einer Achse übernommen</translation>
    </message>
</context>
<context>
    <name>Availability</name>
    <message>
        <source>Program type and machine data can only be changed at standstill. Stop the machine first.</source>
        <translation>Programmart und Maschinendaten lassen sich nur im Stillstand ändern. Zuerst die Maschine stoppen.</translation>
    </message>
    <message>
        <source>Start the machine: this step continues while the machine runs.</source>
        <translation>Maschine starten: dieser Schritt geht weiter, während sie läuft.</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it first: diagnosis and search interrupt the connection.</source>
        <translation>Die Maschine bewegt sich. Zuerst stoppen: Diagnose und Suche unterbrechen die Verbindung.</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before changing the screen.</source>
        <translation>Die Maschine bewegt sich. Vor Änderungen am Bildschirm anhalten.</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before calibrating the touchscreen.</source>
        <translation>Die Maschine bewegt sich. Vor dem Kalibrieren des Touchscreens anhalten.</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before the update; the panel will restart.</source>
        <translation>Die Maschine bewegt sich. Halten Sie sie vor der Aktualisierung an; das Panel startet neu.</translation>
    </message>
    <message>
        <source>The machine is moving. Stop it before restoring; the panel will restart.</source>
        <translation>Die Maschine bewegt sich. Vor dem Rückspielen stoppen; das Panel startet neu.</translation>
    </message>
    <message>
        <source>The controller&apos;s state is unknown.</source>
        <translation>Der Zustand der Steuerung ist unbekannt.</translation>
    </message>
    <message>
        <source>The machine is running. Stop it first.</source>
        <translation>Die Maschine läuft. Zuerst stoppen.</translation>
    </message>
    <message>
        <source>The machine is stopping. Wait for standstill.</source>
        <translation>Die Maschine hält an. Stillstand abwarten.</translation>
    </message>
    <message>
        <source>The reference run is active. Wait for standstill.</source>
        <translation>Die Referenzfahrt läuft. Stillstand abwarten.</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>Die Steuerung ist in Störung. Zuerst die Störung quittieren.</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>Keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>The axis is jogging. Wait for standstill.</source>
        <translation>Die Achse wird getippt. Stillstand abwarten.</translation>
    </message>
</context>
<context>
    <name>BackupErrorText</name>
    <message>
        <source>The file %1 cannot be read: %2. Nothing was changed.</source>
        <translation>Die Datei %1 ist nicht lesbar: %2. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is not a backup of CamPanel. Nothing was changed.</source>
        <translation>%1 ist keine Sicherung von CamPanel. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 was made by the newer CamPanel %2. Install that version first. Nothing was changed.</source>
        <translation>%1 stammt vom neueren CamPanel %2. Zuerst diese Version installieren. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is damaged (%2). Use another backup. Nothing was changed.</source>
        <translation>%1 ist beschädigt (%2). Eine andere Sicherung verwenden. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The backup cannot be unpacked: %1. Free space on this panel. Nothing was changed.</source>
        <translation>Die Sicherung lässt sich nicht entpacken: %1. Platz auf dem Panel schaffen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 MB are required and %2 MB are free</source>
        <translation>%1 MB sind nötig und %2 MB frei</translation>
    </message>
    <message>
        <source>%1 is protected by a password. Unpack it on a computer and pack it as a zip file without a password. Nothing was changed.</source>
        <translation>%1 ist durch ein Passwort geschützt. An einem Computer entpacken und als Zip-Datei ohne Passwort packen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 was packed in a way that this panel cannot read. Unpack it on a computer and pack it as a usual zip file. Nothing was changed.</source>
        <translation>%1 wurde auf eine Weise gepackt, die dieses Panel nicht liest. An einem Computer entpacken und als gewöhnliche Zip-Datei packen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 was altered by another program: %2 is not of CamPanel. Use another backup. Nothing was changed.</source>
        <translation>%1 wurde von einem anderen Programm verändert: %2 ist nicht von CamPanel. Eine andere Sicherung verwenden. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 has no users, but this panel has PINs. Use a backup that was made after the first PIN. Nothing was changed.</source>
        <translation>%1 hat keine Benutzer, dieses Panel aber hat PINs. Eine Sicherung verwenden, die nach der ersten PIN gemacht wurde. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Nobody in %1 can log in as Service: the panel could not be set up any more. Use another backup. Nothing was changed.</source>
        <translation>In %1 kann sich niemand als Service anmelden: Das Panel ließe sich nicht mehr einrichten. Eine andere Sicherung verwenden. Nichts wurde geändert.</translation>
    </message>
</context>
<context>
    <name>CamSentences</name>
    <message>
        <source>The axis advances by %1 per cycle.</source>
        <translation>Die Achse rückt je Zyklus um %1 vor.</translation>
    </message>
    <message>
        <source>The axis advances by %1 in every cycle, and no travel limit stops it.</source>
        <translation>Die Achse rückt in jedem Zyklus um %1 vor, und keine Wegbegrenzung hält sie an.</translation>
    </message>
    <message>
        <source>The ends of the cam differ by %1; the table closes the cam.</source>
        <translation>Die Kurvenenden liegen %1 auseinander; die Tabelle schließt sie.</translation>
    </message>
</context>
<context>
    <name>ConnectionSentences</name>
    <message>
        <source>Connected to the simulated controller.</source>
        <translation>Mit der simulierten Steuerung verbunden.</translation>
    </message>
    <message>
        <source>Connected to the controller on %1.</source>
        <translation>Mit der Steuerung an %1 verbunden.</translation>
    </message>
    <message>
        <source>Identifying the controller on %1 …</source>
        <translation>Steuerung an %1 wird erkannt …</translation>
    </message>
    <message>
        <source>Searching for port %1 …</source>
        <translation>Schnittstelle %1 wird gesucht …</translation>
    </message>
    <message>
        <source>The simulated controller was not found at %1. Install it, or choose a serial port in the settings.</source>
        <translation>Die simulierte Steuerung wurde unter %1 nicht gefunden. Installieren oder in den Einstellungen eine serielle Schnittstelle wählen.</translation>
    </message>
    <message>
        <source>The simulated controller has stopped and is restarting.</source>
        <translation>Die simulierte Steuerung hat angehalten und startet neu.</translation>
    </message>
    <message>
        <source>The simulated controller has stopped and is restarting. Its output: %1</source>
        <translation>Die simulierte Steuerung hat angehalten und startet neu. Ihre Ausgabe: %1</translation>
    </message>
    <message>
        <source>The simulated controller is starting …</source>
        <translation>Die simulierte Steuerung startet …</translation>
    </message>
    <message>
        <source>Port %1 does not exist. Plug the adapter in, or choose another port in the settings.</source>
        <translation>Schnittstelle %1 ist nicht vorhanden. Adapter einstecken oder in den Einstellungen eine andere wählen.</translation>
    </message>
    <message>
        <source>Another program is using port %1. Close that program, or choose another port.</source>
        <translation>Ein anderes Programm belegt %1. Dieses Programm schließen oder eine andere Schnittstelle wählen.</translation>
    </message>
    <message>
        <source>This user has no right to use port %1. Add the user to the group &quot;%2&quot; and log in again.</source>
        <translation>Dieser Benutzer darf %1 nicht verwenden. Ihn der Gruppe „%2“ hinzufügen und neu anmelden.</translation>
    </message>
    <message>
        <source>This user has no right to use port %1. Ask the administrator for this right.</source>
        <translation>Dieser Benutzer darf Schnittstelle %1 nicht benutzen. Den Administrator um das Recht bitten.</translation>
    </message>
    <message>
        <source>%1 is not a serial port. Choose another port in the settings.</source>
        <translation>%1 ist keine serielle Schnittstelle. In den Einstellungen eine andere wählen.</translation>
    </message>
    <message>
        <source>Port %1 cannot be set up: %2. Choose other settings.</source>
        <translation>Schnittstelle %1 lässt sich nicht einrichten: %2. Andere Einstellungen wählen.</translation>
    </message>
    <message>
        <source>Port %1 was removed. Plug the adapter in again.</source>
        <translation>Schnittstelle %1 wurde entfernt. Adapter wieder einstecken.</translation>
    </message>
    <message>
        <source>No response on %1. Check cable, power, baud rate, parity and unit number.</source>
        <translation>Keine Antwort an %1. Kabel, Versorgung, Baudrate, Parität und Gerätenummer prüfen.</translation>
    </message>
    <message>
        <source>Invalid data on %1. Check baud rate, parity and stop bits.</source>
        <translation>Ungültige Daten an %1. Baudrate, Parität und Stoppbits prüfen.</translation>
    </message>
    <message>
        <source>Stray bytes behind a response on %1. Check the bias resistors, and the switching between sending and receiving.</source>
        <translation>Fremde Bytes hinter einer Antwort an %1. Vorspannungswiderstände und Umschaltung zwischen Senden und Empfangen prüfen.</translation>
    </message>
    <message>
        <source>Responses on %1 belong to other requests. Check for another master on the line.</source>
        <translation>Antworten an %1 gehören zu anderen Anfragen. Auf einen zweiten Master am Bus prüfen.</translation>
    </message>
    <message>
        <source>The device on %1 reports a failure (Modbus exception %2). Restart the device.</source>
        <translation>Das Gerät an %1 meldet einen Fehler (Modbus-Ausnahme %2). Das Gerät neu starten.</translation>
    </message>
    <message>
        <source>The device on %1 is busy (Modbus exception %2). Wait, or restart the device.</source>
        <translation>Das Gerät an %1 ist beschäftigt (Modbus-Ausnahme %2). Warten oder das Gerät neu starten.</translation>
    </message>
    <message>
        <source>The gateway on %1 gets no response from the controller (Modbus exception %2). Check the unit number, and the line behind the gateway.</source>
        <translation>Das Gateway an %1 erhält keine Antwort von der Steuerung (Modbus-Ausnahme %2). Gerätenummer und Leitung hinter dem Gateway prüfen.</translation>
    </message>
    <message>
        <source>The device on %1 refuses the request (Modbus exception %2). Check that it is a CamPanel controller.</source>
        <translation>Das Gerät an %1 lehnt die Anfrage ab (Modbus-Ausnahme %2). Prüfen, ob es eine CamPanel-Steuerung ist.</translation>
    </message>
    <message>
        <source>The device on %1 is not a CamPanel controller. Choose another port or unit number.</source>
        <translation>Das Gerät an %1 ist keine CamPanel-Steuerung. Andere Schnittstelle oder Gerätenummer wählen.</translation>
    </message>
    <message>
        <source>The controller on %1 has register map version %2, not %3. Update the older device.</source>
        <translation>Die Steuerung an %1 hat Registerplan %2, nicht %3. Das ältere Gerät aktualisieren.</translation>
    </message>
    <message>
        <source>The controller on %1 reports an impossible value: %2 is %3. Update its firmware.</source>
        <translation>Die Steuerung an %1 meldet einen unmöglichen Wert: %2 ist %3. Ihre Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>The controller on %1 lacks required registers. Update its firmware.</source>
        <translation>Der Steuerung an %1 fehlen nötige Register. Ihre Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>The controller did not receive the command. Try again.</source>
        <translation>Die Steuerung hat den Befehl nicht empfangen. Erneut versuchen.</translation>
    </message>
    <message>
        <source>It is unknown whether the controller received the command. Check the machine before you try again.</source>
        <translation>Unbekannt, ob die Steuerung den Befehl empfangen hat. Vor einem neuen Versuch die Maschine prüfen.</translation>
    </message>
    <message>
        <source>The controller stored a different value. Try again.</source>
        <translation>Die Steuerung hat einen anderen Wert gespeichert. Erneut versuchen.</translation>
    </message>
    <message>
        <source>The controller does not allow this access to %1.</source>
        <translation>Die Steuerung erlaubt diesen Zugriff auf %1 nicht.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>%1 was refused. %2</source>
        <comment>%1: command, %2: whole sentence</comment>
        <translation>%1 wurde abgelehnt. %2</translation>
    </message>
    <message>
        <source>%1 was not sent: there is no connection to the controller.</source>
        <translation>%1 wurde nicht gesendet: keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>%1 did not reach the controller. Try again.</source>
        <translation>%1 hat die Steuerung nicht erreicht. Erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 was sent, but no response was received. Check the machine before you try again.</source>
        <translation>%1 wurde gesendet, aber ohne Antwort. Vor einem neuen Versuch die Maschine prüfen.</translation>
    </message>
    <message>
        <source>Not downloaded: there is no connection to the controller.</source>
        <translation>Nicht geladen: keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>Not downloaded: another download is in progress.</source>
        <translation>Nicht geladen: ein anderes Laden läuft.</translation>
    </message>
    <message>
        <source>The connection is lost. The download continues when it is restored.</source>
        <translation>Die Verbindung ist verloren. Das Laden wird danach fortgesetzt.</translation>
    </message>
    <message>
        <source>Sending the table …</source>
        <translation>Tabelle wird gesendet …</translation>
    </message>
    <message>
        <source>The controller is checking the table …</source>
        <translation>Die Steuerung prüft die Tabelle …</translation>
    </message>
    <message>
        <source>Checked. The program becomes active at the end of the cycle.</source>
        <translation>Geprüft. Das Programm wird am Ende des Zyklus aktiv.</translation>
    </message>
    <message>
        <source>Canceled. The controller&apos;s program is unchanged.</source>
        <translation>Abgebrochen. Das Programm der Steuerung ist unverändert.</translation>
    </message>
    <message>
        <source>Download failed; the controller&apos;s program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>Laden fehlgeschlagen; das Programm der Steuerung ist unverändert. %1</translation>
    </message>
    <message>
        <source>The table needs %1 registers, the controller has %2; its program is unchanged. Use fewer slices per ramp.</source>
        <translation>Die Tabelle braucht %1 Register, die Steuerung hat %2; ihr Programm ist unverändert. Weniger Teilschritte je Rampe wählen.</translation>
    </message>
    <message>
        <source>This controller cannot execute intervals; its program is unchanged. Choose cam points.</source>
        <translation>Diese Steuerung kann keine Intervalle ausführen; ihr Programm ist unverändert. Wählen Sie Kurvenpunkte.</translation>
    </message>
    <message>
        <source>This controller cannot execute this kind of program; its program is unchanged. Update its firmware.</source>
        <translation>Diese Steuerung kann diese Programmart nicht ausführen; ihr Programm ist unverändert. Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>The controller refused the table; its program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>Die Steuerung hat die Tabelle abgelehnt; ihr Programm ist unverändert. %1</translation>
    </message>
    <message>
        <source>The received data differ from the sent data; the controller&apos;s program is unchanged. Download again.</source>
        <translation>Die empfangenen Daten weichen ab; das Programm der Steuerung ist unverändert. Erneut laden.</translation>
    </message>
    <message>
        <source>The controller did not apply the table; its program is unchanged. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>Die Steuerung hat die Tabelle nicht übernommen; ihr Programm ist unverändert. %1</translation>
    </message>
    <message>
        <source>The change was withdrawn before it became active; the controller&apos;s program is unchanged.</source>
        <translation>Die Änderung wurde zurückgezogen, bevor sie aktiv wurde; das Programm der Steuerung ist unverändert.</translation>
    </message>
    <message>
        <source>%1 was not changed: there is no connection to the controller.</source>
        <translation>%1 wurde nicht geändert: keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>%1 was not changed. %2</source>
        <comment>%2: whole sentence</comment>
        <translation>%1 wurde nicht geändert. %2</translation>
    </message>
    <message>
        <source>%1 was sent, but not confirmed. Check the machine before you try again.</source>
        <translation>%1 wurde gesendet, aber nicht bestätigt. Vor einem neuen Versuch die Maschine prüfen.</translation>
    </message>
    <message>
        <source>The diagnostics are using the ports. The panel reconnects when they have finished.</source>
        <translation>Die Diagnose belegt die Schnittstellen. Danach verbindet sich das Panel wieder.</translation>
    </message>
    <message>
        <source>No connection since %1 to the simulated controller on %2. The panel reconnects automatically.</source>
        <translation>Seit %1 keine Verbindung zur simulierten Steuerung an %2. Das Panel verbindet sich selbsttätig.</translation>
    </message>
    <message>
        <source>No connection since %1: port %2 was removed. Plug the adapter in again; the panel finds it under any name and reconnects automatically.</source>
        <translation>Seit %1 keine Verbindung: %2 wurde entfernt. Adapter wieder einstecken; das Panel findet ihn unter jedem Namen und verbindet sich selbsttätig.</translation>
    </message>
    <message>
        <source>No connection since %1: port %2 was removed. Plug the adapter into the same socket; the panel reconnects automatically.</source>
        <translation>Keine Verbindung seit %1: Schnittstelle %2 wurde entfernt. Adapter in dieselbe Buchse stecken; das Panel verbindet automatisch neu.</translation>
    </message>
    <message>
        <source>No connection since %1. %2</source>
        <comment>time, %2: whole sentences</comment>
        <translation>Keine Verbindung seit %1. %2</translation>
    </message>
    <message>
        <source>No connection since %1: no response on %2. Check the cable and the controller&apos;s power; the panel reconnects automatically.</source>
        <translation>Seit %1 keine Verbindung: keine Antwort an %2. Kabel und Versorgung der Steuerung prüfen; das Panel verbindet sich selbsttätig.</translation>
    </message>
    <message>
        <source>No controller is selected. Select one on the Settings page, under Connection.</source>
        <translation>Keine Steuerung gewählt. Eine auf der Seite Einstellungen unter Verbindung wählen.</translation>
    </message>
    <message>
        <source>The controller has this program.</source>
        <translation>Die Steuerung hat dieses Programm.</translation>
    </message>
</context>
<context>
    <name>ControllerSentences</name>
    <message>
        <source>The machine keeps following the line; the new recipe starts with the next cycle.</source>
        <translation>Die Maschine folgt weiter der Linie; das neue Rezept beginnt mit dem nächsten Zyklus.</translation>
    </message>
    <message>
        <source>Stops at the end of a cycle, then follows the line again (%1 at its present speed).</source>
        <translation>Hält am Ende eines Zyklus und folgt dann wieder der Linie (%1 bei ihrer jetzigen Geschwindigkeit).</translation>
    </message>
    <message>
        <source>The machine keeps running; the new recipe starts with the next cycle.</source>
        <translation>Die Maschine läuft weiter; das neue Rezept beginnt mit dem nächsten Zyklus.</translation>
    </message>
    <message>
        <source>Slows down to %1 % (bags: %2, %3), then %4 bags/min.</source>
        <translation>Wird auf %1 % langsamer (Beutel: %2, %3), dann %4 Beutel/min.</translation>
    </message>
    <message>
        <source>Slows down to %1 % (cycles: %2, %3), then full speed.</source>
        <translation>Wird auf %1 % langsamer (Zyklen: %2, %3), dann volle Geschwindigkeit.</translation>
    </message>
    <message>
        <source>%1 A product under the first cut adds %2 s.</source>
        <translation>%1 Ein Produkt unter dem ersten Schnitt verlängert das um %2 s.</translation>
    </message>
    <message>
        <source>at least %1 s</source>
        <translation>mindestens %1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The controller reports reason %1, which this panel does not know. Update the panel.</source>
        <translation>Die Steuerung meldet Grund %1, den dieses Panel nicht kennt. Panel aktualisieren.</translation>
    </message>
    <message>
        <source>No slowing down. Speeds up to %1 bags/min within %2.</source>
        <translation>Wird nicht langsamer. Beschleunigt innerhalb von %2 auf %1 Beutel/min.</translation>
    </message>
    <message>
        <source>No slowing down. Speeds up to full speed within %1.</source>
        <translation>Wird nicht langsamer. Beschleunigt innerhalb von %1 auf volle Geschwindigkeit.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>numbers of bags</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Scrap bags: %1; the first good bag within %2 s.</source>
        <translation>Ausschussbeutel: %1; der erste gute Beutel innerhalb von %2 s.</translation>
    </message>
    <message>
        <source>%1 Skipped cuts: up to %2, a bag of up to %3.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Ausgelassene Schnitte: bis zu %2, ein Beutel bis %3.</translation>
    </message>
    <message>
        <source>Changing to %1: scrap %2, up to %3 s</source>
        <translation>Wechsel auf %1: Ausschuss %2, bis zu %3 s</translation>
    </message>
    <message>
        <source>Changing to %1: scrap %2, a bag of up to %4, up to %3 s</source>
        <translation>Wechsel auf %1: Ausschuss %2, Beutel bis %4, bis zu %3 s</translation>
    </message>
</context>
<context>
    <name>DifferencesText</name>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Speed law</source>
        <translation>Bewegungsgesetz</translation>
    </message>
    <message>
        <source>Pinned values</source>
        <translation>Feste Werte</translation>
    </message>
    <message>
        <source>Law parameter 2</source>
        <translation>Parameter 2 des Gesetzes</translation>
    </message>
    <message>
        <source>Law parameter 1</source>
        <translation>Parameter 1 des Gesetzes</translation>
    </message>
    <message>
        <source>Program type</source>
        <translation>Programmart</translation>
    </message>
    <message>
        <source>Displacement law</source>
        <translation>Bewegungsgesetz</translation>
    </message>
</context>
<context>
    <name>DoctorSentences</name>
    <message>
        <source>%1 baud, 8%2%3, unit %4</source>
        <comment>parity letter, stop bits</comment>
        <translation>%1 Baud, 8%2%3, Gerät %4</translation>
    </message>
    <message>
        <source>Controller found</source>
        <translation>Steuerung gefunden</translation>
    </message>
    <message>
        <source>Controller at another unit number</source>
        <translation>Steuerung unter anderer Gerätenummer</translation>
    </message>
    <message>
        <source>Controller with another version</source>
        <translation>Steuerung anderer Version</translation>
    </message>
    <message>
        <source>Another device</source>
        <translation>Anderes Gerät</translation>
    </message>
    <message>
        <source>Invalid data</source>
        <translation>Ungültige Daten</translation>
    </message>
    <message>
        <source>No response</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Echo only</source>
        <translation>Nur Echo</translation>
    </message>
    <message>
        <source>Error response</source>
        <translation>Fehlerantwort</translation>
    </message>
    <message>
        <source>Port does not exist</source>
        <translation>Schnittstelle fehlt</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>In use by another program</source>
        <translation>Von anderem Programm belegt</translation>
    </message>
    <message>
        <source>Not a serial port</source>
        <translation>Keine serielle Schnittstelle</translation>
    </message>
    <message>
        <source>Settings not supported</source>
        <translation>Einstellungen nicht unterstützt</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>Abgezogen</translation>
    </message>
    <message>
        <source>A CamPanel controller with firmware %1 responds.</source>
        <translation>Eine CamPanel-Steuerung mit Firmware %1 antwortet.</translation>
    </message>
    <message>
        <source>A CamPanel controller responds at unit number %1, which differs from the setting. Use this connection, or set the unit number at the controller.</source>
        <translation>Eine CamPanel-Steuerung antwortet unter Gerätenummer %1, die von der Einstellung abweicht. Diese Verbindung verwenden oder die Nummer an der Steuerung einstellen.</translation>
    </message>
    <message>
        <source>A CamPanel controller responds with register map version %1, not %2. Update the older device.</source>
        <translation>Eine CamPanel-Steuerung antwortet mit Registerplan %1, nicht %2. Das ältere Gerät aktualisieren.</translation>
    </message>
    <message>
        <source>The responding device is not a CamPanel controller. Choose another port or unit number.</source>
        <translation>Das antwortende Gerät ist keine CamPanel-Steuerung. Andere Schnittstelle oder Gerätenummer wählen.</translation>
    </message>
    <message>
        <source>%1 bytes were received, but no valid response. Check baud rate, parity and stop bits, or search for the controller; then check shield and ground.</source>
        <translation>%1 Bytes empfangen, aber keine gültige Antwort. Baudrate, Parität und Stoppbits prüfen oder Steuerung suchen; dann Schirm und Erdung prüfen.</translation>
    </message>
    <message>
        <source>No data was received. Check the controller&apos;s power and both ends of the cable; on RS-232 cross the transmit and receive wires, on RS-485 check A and B.</source>
        <translation>Keine Daten empfangen. Versorgung der Steuerung und beide Kabelenden prüfen; bei RS-232 Sende- und Empfangsader kreuzen, bei RS-485 A und B prüfen.</translation>
    </message>
    <message>
        <source>The adapter echoes the requests, and no controller responds. Check the controller&apos;s power, both ends of the cable, and A and B.</source>
        <translation>Der Adapter gibt die Anfragen als Echo zurück, keine Steuerung antwortet. Versorgung der Steuerung, beide Kabelenden sowie A und B prüfen.</translation>
    </message>
    <message>
        <source>%1 The line adds stray bytes to the responses (%2). Check the bias resistors, and the switching between sending and receiving.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Die Leitung fügt den Antworten fremde Bytes hinzu (%2). Vorspannungswiderstände und Umschaltung zwischen Senden und Empfangen prüfen.</translation>
    </message>
    <message>
        <source>%1 The USB adapter delays data by %2 ms: set its latency timer to 1 ms.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Der USB-Adapter verzögert Daten um %2 ms: seinen Latenz-Timer auf 1 ms stellen.</translation>
    </message>
    <message>
        <source>This port does not exist. Plug the adapter in, or choose another port in the settings.</source>
        <translation>Diese Schnittstelle ist nicht vorhanden. Adapter einstecken oder in den Einstellungen eine andere wählen.</translation>
    </message>
    <message>
        <source>This user has no right to use the port. Ask the administrator for this right.</source>
        <translation>Dieser Benutzer darf die Schnittstelle nicht verwenden. Den Administrator um das Recht bitten.</translation>
    </message>
    <message>
        <source>This user has no right to use the port. Add the user to the group &quot;%1&quot; and log in again.</source>
        <translation>Dieser Benutzer darf die Schnittstelle nicht verwenden. Ihn der Gruppe „%1“ hinzufügen und neu anmelden.</translation>
    </message>
    <message>
        <source>This is not a serial port. Choose another port in the settings.</source>
        <translation>Das ist keine serielle Schnittstelle. In den Einstellungen eine andere wählen.</translation>
    </message>
    <message>
        <source>The port cannot be set up: %1. Choose other settings.</source>
        <translation>Die Schnittstelle lässt sich nicht einrichten: %1. Andere Einstellungen wählen.</translation>
    </message>
    <message>
        <source>The adapter was removed during the test. Check its plug and cable.</source>
        <translation>Der Adapter wurde während der Prüfung entfernt. Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>Prozess %1</translation>
    </message>
    <message>
        <source>%1 (process %2)</source>
        <translation>%1 (Prozess %2)</translation>
    </message>
    <message>
        <source>Another program is using this port. Close that program, or choose another port.</source>
        <translation>Ein anderes Programm belegt diese Schnittstelle. Es schließen oder eine andere wählen.</translation>
    </message>
    <message>
        <source>The port is in use by %1. Close that program, or choose another port.</source>
        <translation>Die Schnittstelle ist von %1 belegt. Dieses Programm schließen oder eine andere wählen.</translation>
    </message>
    <message>
        <source>%1 of %2, max. %3 min left</source>
        <translation>%1 von %2, noch max. %3 min</translation>
    </message>
    <message>
        <source>%1 of %2, max. %3 s left</source>
        <translation>%1 von %2, noch max. %3 s</translation>
    </message>
</context>
<context>
    <name>EditorViews</name>
    <message>
        <source>RMS</source>
        <translation>Effektiv</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1/min</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 kHz</source>
        <translation>max. %1/min · %2 · %3 kHz</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>Knapp innerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>Within all limits.</source>
        <translation>Innerhalb aller Grenzen.</translation>
    </message>
    <message>
        <source>Within all limits; building the table …</source>
        <translation>Innerhalb aller Grenzen; Tabelle wird erstellt …</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>Max.
Drehzahl</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschl.</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>Torque,
RMS</source>
        <translation>Moment,
Effektiv</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Error while
sealing</source>
        <translation>Fehler beim
Siegeln</translation>
    </message>
    <message>
        <source>Vibration
after the move</source>
        <translation>Schwingung
danach</translation>
    </message>
    <message>
        <source>%1 Nm
RMS %2</source>
        <comment>peak and RMS torque</comment>
        <translation>%1 Nm
eff. %2</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 Nm (RMS %5) · %4 kHz</source>
        <translation>max. %1/min · %2 · %3 Nm (eff. %5) · %4 kHz</translation>
    </message>
    <message>
        <source>peak %1 r/min · %2 · %3 kHz · seal %4 ms</source>
        <translation>max. %1/min · %2 · %3 kHz · Siegeln %4 ms</translation>
    </message>
    <message>
        <source>Max. master speed</source>
        <translation>Max. Leitgeschw.</translation>
    </message>
    <message>
        <source>Rate at max. line speed</source>
        <translation>Taktzahl bei max. Linie</translation>
    </message>
    <message>
        <source>An encoder leads: the line travels %1 of film at this rate. The run ends above %2.</source>
        <translation>Ein Drehgeber führt: bei dieser Taktzahl läuft die Linie mit %1 Folie. Über %2 endet der Lauf.</translation>
    </message>
</context>
<context>
    <name>FileErrorText</name>
    <message>
        <source>The file %1 does not exist. Check its name.</source>
        <translation>Die Datei %1 ist nicht vorhanden. Namen prüfen.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read: %2.</source>
        <translation>Die Datei %1 ist nicht lesbar: %2.</translation>
    </message>
    <message>
        <source>The recipe could not be saved to %1: %2; the stored recipe is unchanged. Free disk space or check the permissions, then save again.</source>
        <translation>Das Rezept konnte nicht nach %1 gespeichert werden: %2; das gespeicherte Rezept ist unverändert. Platz schaffen oder Rechte prüfen, dann erneut speichern.</translation>
    </message>
    <message>
        <source>The file %1 is damaged at byte %2: %3. Restore it from a copy.</source>
        <translation>Die Datei %1 ist bei Byte %2 beschädigt: %3. Aus einer Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>%1 is not a CamPanel recipe: the key &quot;format&quot; must be &quot;campanel-recipe&quot;.</source>
        <translation>%1 ist kein CamPanel-Rezept: Der Schlüssel &quot;format&quot; muss &quot;campanel-recipe&quot; sein.</translation>
    </message>
    <message>
        <source>The file %1 has format version %2, this program reads versions up to %3. Update the program.</source>
        <translation>Die Datei %1 hat die Formatversion %2, dieses Programm liest Versionen bis %3. Aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>The file %1 has an unknown key %2. Correct or remove the key.</source>
        <translation>Die Datei %1 hat einen unbekannten Schlüssel %2. Schlüssel korrigieren oder entfernen.</translation>
    </message>
    <message>
        <source>The file %1 lacks the key %2. Add the key.</source>
        <translation>In der Datei %1 fehlt der Schlüssel %2. Schlüssel ergänzen.</translation>
    </message>
    <message>
        <source>In the file %1, %2 must be %3.</source>
        <translation>In der Datei %1 muss %2 %3 sein.</translation>
    </message>
    <message>
        <source>In the file %1, %2 is %3; enter %4.</source>
        <translation>In der Datei %1 ist %2 gleich %3; %4 eingeben.</translation>
    </message>
    <message>
        <source>In the file %1, %2 is &quot;%3&quot;; choose one of: %4.</source>
        <translation>In der Datei %1 ist %2 „%3“; eines davon wählen: %4.</translation>
    </message>
    <message>
        <source>In the file %1, %2 is longer than %3 bytes. Shorten the text.</source>
        <translation>In der Datei %1 ist %2 länger als %3 Bytes. Text kürzen.</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>an object in braces</source>
        <translation>ein Objekt in geschweiften Klammern</translation>
    </message>
    <message>
        <source>a list of two of bag_length_mm, rate_bags_per_min, base_speed_mm_per_s, film_speed_mm_per_s</source>
        <translation>eine Liste von zwei aus bag_length_mm, rate_bags_per_min, base_speed_mm_per_s, film_speed_mm_per_s</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>pairs of master angle and position</source>
        <translation>Paare aus Leitwinkel und Position</translation>
    </message>
    <message>
        <source>%1 values, as in the header</source>
        <translation>%1 Werte, wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>eine Zahl mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>a number with a decimal comma</source>
        <translation>eine Zahl mit Dezimalkomma</translation>
    </message>
    <message>
        <source>at least one line of values</source>
        <translation>mindestens eine Zeile mit Werten</translation>
    </message>
    <message>
        <source>The file %1 is not UTF-8 text. Save the file as CSV in UTF-8.</source>
        <translation>Die Datei %1 ist kein UTF-8-Text. Als CSV in UTF-8 speichern.</translation>
    </message>
    <message>
        <source>%1, line %2: expected %3, found &quot;%4&quot;.</source>
        <translation>%1, Zeile %2: erwartet %3, gefunden „%4“.</translation>
    </message>
    <message>
        <source>The file %1 cannot be written: %2.</source>
        <translation>Die Datei %1 lässt sich nicht schreiben: %2.</translation>
    </message>
    <message>
        <source>This panel</source>
        <translation>Dieses Panel</translation>
    </message>
    <message>
        <source>%1 Free some space, unlock the stick or choose another location.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Platz schaffen, Stick entsperren oder einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>The file %1 has the key %2 twice. Remove one of them.</source>
        <translation>Die Datei %1 hat den Schlüssel %2 zweimal. Einen davon entfernen.</translation>
    </message>
    <message>
        <source>The file %1 is signed by %2, whose key this machine does not have. Ask Service to install the key, or have it signed by somebody else.</source>
        <translation>Die Datei %1 ist von %2 signiert, dessen Schlüssel diese Maschine nicht hat. Den Schlüssel vom Service installieren oder sie von jemand anderem signieren lassen.</translation>
    </message>
    <message>
        <source>The file %1 is signed by %2, whose key was withdrawn. Have it signed with a valid key.</source>
        <translation>Die Datei %1 ist von %2 signiert, dessen Schlüssel zurückgezogen wurde. Sie mit einem gültigen Schlüssel signieren lassen.</translation>
    </message>
    <message>
        <source>The file %1 does not match the signature of %2: it was changed, or another key signed it. Ask for a new copy.</source>
        <translation>Die Datei %1 passt nicht zur Signatur von %2: sie wurde geändert oder mit einem anderen Schlüssel signiert. Eine neue Kopie anfordern.</translation>
    </message>
    <message>
        <source>not a regular file</source>
        <translation>keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>larger than 1 MB</source>
        <translation>größer als 1 MB</translation>
    </message>
    <message>
        <source>the header %1</source>
        <translation>die Kopfzeile %1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>eines von: %1</translation>
    </message>
    <message>
        <source>a list of objects</source>
        <translation>eine Liste von Objekten</translation>
    </message>
    <message>
        <source>The file %1 is not signed; the plant&apos;s network offers signed files only. Have it signed.</source>
        <translation>Die Datei %1 ist nicht signiert; das Werksnetz bietet nur signierte Dateien an. Datei signieren lassen.</translation>
    </message>
    <message>
        <source>Plant network</source>
        <translation>Werksnetz</translation>
    </message>
    <message>
        <source>In the file %1, %2 has the character %3, which nobody can see. Remove the character.</source>
        <translation>In der Datei %1 enthält %2 das unsichtbare Zeichen %3. Das Zeichen entfernen.</translation>
    </message>
    <message>
        <source>a text of visible characters</source>
        <translation>ein Text aus sichtbaren Zeichen</translation>
    </message>
    <message>
        <source>%1 does not answer. Check the network or plug the stick in again.</source>
        <translation>%1 antwortet nicht. Netzwerk prüfen oder den Stick neu einstecken.</translation>
    </message>
    <message>
        <source>%1 older files of %2 are not shown. Delete files that are not needed, or move them into a folder.</source>
        <translation>%1 ältere Dateien von %2 fehlen in der Liste. Nicht benötigte Dateien löschen oder in einen Ordner verschieben.</translation>
    </message>
</context>
<context>
    <name>FrameWords</name>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>Von der Steuerung abgelehnt</translation>
    </message>
    <message>
        <source>Dropped: response to another request</source>
        <translation>Verworfen: Antwort auf andere Anfrage</translation>
    </message>
    <message>
        <source>Dropped: wrong checksum</source>
        <translation>Verworfen: falsche Prüfsumme</translation>
    </message>
    <message>
        <source>Dropped: invalid frame</source>
        <translation>Verworfen: ungültiges Telegramm</translation>
    </message>
    <message>
        <source>Dropped: incomplete frame</source>
        <translation>Verworfen: unvollständiges Telegramm</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>Antwort blieb aus</translation>
    </message>
    <message>
        <source>Skipped: stray bytes</source>
        <translation>Übersprungen: fremde Bytes</translation>
    </message>
    <message>
        <source>Dropped: no request pending</source>
        <translation>Verworfen: keine Anfrage offen</translation>
    </message>
    <message>
        <source>Port removed</source>
        <translation>Schnittstelle entfernt</translation>
    </message>
    <message>
        <source>Status request, heartbeat %1</source>
        <translation>Statusanfrage, Lebenszeichen %1</translation>
    </message>
    <message>
        <source>Command %1, counter %2</source>
        <comment>name, number</comment>
        <translation>Befehl %1, Zähler %2</translation>
    </message>
    <message>
        <source>Transfer %1, block %2</source>
        <comment>operation, number</comment>
        <translation>Übertragung %1, Block %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Schreiben %1</translation>
    </message>
    <message>
        <source>Sent: function %1</source>
        <translation>Gesendet: Funktion %1</translation>
    </message>
    <message>
        <source>Status: %1, %2</source>
        <comment>state, angle</comment>
        <translation>Status: %1, %2</translation>
    </message>
    <message>
        <source>Command %1: %2</source>
        <comment>name, what became of it</comment>
        <translation>Befehl %1: %2</translation>
    </message>
    <message>
        <source>Transfer %1: %2</source>
        <comment>operation, what became of it</comment>
        <translation>Übertragung %1: %2</translation>
    </message>
    <message>
        <source>Response: done</source>
        <translation>Antwort: ausgeführt</translation>
    </message>
    <message>
        <source>Response: %1</source>
        <translation>Antwort: %1</translation>
    </message>
    <message>
        <source>Exception %1: %2</source>
        <comment>number, name</comment>
        <translation>Ausnahme %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <comment>what, number</comment>
        <translation>%1, %2 Bytes</translation>
    </message>
    <message>
        <source>Unit %1, function %2</source>
        <translation>Gerät %1, Funktion %2</translation>
    </message>
    <message>
        <source>Read %1, count %2</source>
        <translation>Lesen %1, Anzahl %2</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>English</source>
        <extracomment>The name of the language in the language itself; without it the file is not used.</extracomment>
        <translation>Deutsch</translation>
    </message>
</context>
<context>
    <name>LastRecipe</name>
    <message>
        <source>%1 The last good copy is used.</source>
        <translation>%1 Die letzte gute Kopie wird verwendet.</translation>
    </message>
    <message>
        <source>%1 There is no good copy; the default recipe is used.</source>
        <translation>%1 Es gibt keine gute Kopie; das Standardrezept wird verwendet.</translation>
    </message>
</context>
<context>
    <name>MasterSentences</name>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
    <message>
        <source>Place of the encoder</source>
        <translation>Ort des Drehgebers</translation>
    </message>
    <message>
        <source>Signal of the encoder</source>
        <translation>Signal des Drehgebers</translation>
    </message>
    <message>
        <source>Encoder counts backward</source>
        <translation>Drehgeber zählt rückwärts</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Impulse je Umdrehung</translation>
    </message>
    <message>
        <source>Film per revolution</source>
        <translation>Folie je Umdrehung</translation>
    </message>
    <message>
        <source>Delay compensation</source>
        <translation>Verzögerungsausgleich</translation>
    </message>
    <message>
        <source>Delay of the drive</source>
        <translation>Verzögerung des Antriebs</translation>
    </message>
    <message>
        <source>Time constant of the position</source>
        <translation>Zeitkonstante der Position</translation>
    </message>
    <message>
        <source>Stretch for engaging</source>
        <translation>Strecke zum Einkuppeln</translation>
    </message>
    <message>
        <source>Max. speed of the master</source>
        <translation>Max. Leitgeschwindigkeit</translation>
    </message>
    <message>
        <source>Cam follows backward</source>
        <translation>Kurve folgt rückwärts</translation>
    </message>
    <message>
        <source>Limit of the index mark</source>
        <translation>Grenze der Nullmarke</translation>
    </message>
    <message>
        <source>Limit of the wheel&apos;s slip</source>
        <translation>Grenze des Messradschlupfs</translation>
    </message>
    <message>
        <source>Phase of the line</source>
        <translation>Phase der Linie</translation>
    </message>
    <message>
        <source>This recipe is for an encoder as the master, and the controller has no input for one. Change the master of the recipe, or use another controller.</source>
        <translation>Dieses Rezept ist für einen Drehgeber als Leitachse, und die Steuerung hat dafür keinen Eingang. Die Leitachse des Rezepts ändern oder eine andere Steuerung verwenden.</translation>
    </message>
    <message>
        <source>This recipe is for an encoder as the master, but the machine follows its clock. Set the encoder as the master of the machine, or change the master of the recipe.</source>
        <translation>Dieses Rezept ist für einen Drehgeber als Leitachse, aber die Maschine folgt ihrem Takt. Den Drehgeber als Leitachse der Maschine einstellen oder die Leitachse des Rezepts ändern.</translation>
    </message>
    <message>
        <source>This recipe is for the clock, but an encoder leads the machine. Set the clock as the master of the machine, or change the master of the recipe.</source>
        <translation>Dieses Rezept ist für den Takt der Steuerung, aber ein Drehgeber führt die Maschine. Den Takt als Leitachse der Maschine einstellen oder die Leitachse des Rezepts ändern.</translation>
    </message>
    <message>
        <source>As the machine</source>
        <translation>Wie die Maschine</translation>
    </message>
    <message>
        <source>Clock of the controller</source>
        <translation>Takt der Steuerung</translation>
    </message>
    <message>
        <source>Encoder of the line</source>
        <translation>Drehgeber der Linie</translation>
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
        <source>The line sets the rate: an encoder leads the machine. Change the speed of the line.</source>
        <translation>Die Linie bestimmt die Taktzahl: ein Drehgeber führt die Maschine. Die Geschwindigkeit der Linie ändern.</translation>
    </message>
</context>
<context>
    <name>NetworkAddress</name>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Subnet mask</source>
        <translation>Subnetzmaske</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>DNS server</source>
        <translation>DNS-Server</translation>
    </message>
    <message>
        <source>Four numbers from 0 to 255, such as 192.168.1.20. Each device has its own.</source>
        <translation>Vier Zahlen von 0 bis 255, zum Beispiel 192.168.1.20. Jedes Gerät hat eine eigene.</translation>
    </message>
    <message>
        <source>A mask, such as 255.255.255.0, or its length, such as 24.</source>
        <translation>Eine Maske, zum Beispiel 255.255.255.0, oder ihre Länge, zum Beispiel 24.</translation>
    </message>
    <message>
        <source>The device that leads to other networks. Empty: none.</source>
        <translation>Das Gerät, das in andere Netze führt. Leer: keines.</translation>
    </message>
    <message>
        <source>The device that knows the names of computers. Empty: none.</source>
        <translation>Das Gerät, das die Namen der Rechner kennt. Leer: keines.</translation>
    </message>
    <message>
        <source>Not a subnet mask. Enter a mask from 128.0.0.0 to 255.255.255.252, or its length from 1 to 30.</source>
        <translation>Keine Subnetzmaske. Geben Sie eine Maske von 128.0.0.0 bis 255.255.255.252 ein, oder ihre Länge von 1 bis 30.</translation>
    </message>
    <message>
        <source>Not an IPv4 address. Enter four numbers from 0 to 255 with points between them.</source>
        <translation>Keine IPv4-Adresse. Geben Sie vier Zahlen von 0 bis 255 mit Punkten dazwischen ein.</translation>
    </message>
    <message>
        <source>No device has this address. The first number is from 1 to 223, and not 127.</source>
        <translation>Diese Adresse hat kein Gerät. Die erste Zahl ist von 1 bis 223, und nicht 127.</translation>
    </message>
    <message>
        <source>%1 is the subnet itself. Enter an address from %2 to %3, or another mask.</source>
        <translation>%1 ist das Subnetz selbst. Geben Sie eine Adresse von %2 bis %3 ein, oder eine andere Maske.</translation>
    </message>
    <message>
        <source>%1 is the broadcast address. Enter an address from %2 to %3, or another mask.</source>
        <translation>%1 ist die Broadcast-Adresse. Geben Sie eine Adresse von %2 bis %3 ein, oder eine andere Maske.</translation>
    </message>
    <message>
        <source>The gateway has the address of this panel. Enter the gateway&apos;s address, or none.</source>
        <translation>Das Gateway hat die Adresse dieses Panels. Geben Sie die Adresse des Gateways ein, oder keine.</translation>
    </message>
    <message>
        <source>The gateway is not in the subnet. Enter a gateway from %1 to %2, or another mask.</source>
        <translation>Das Gateway ist nicht im Subnetz. Geben Sie ein Gateway von %1 bis %2 ein, oder eine andere Maske.</translation>
    </message>
</context>
<context>
    <name>OrderWords</name>
    <message>
        <source>Queued</source>
        <translation>In der Warteschlange</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Ended early</source>
        <translation>Vorzeitig beendet</translation>
    </message>
    <message>
        <source>The run goes on</source>
        <translation>Der Lauf geht weiter</translation>
    </message>
    <message>
        <source>Message %1 bags before the end</source>
        <translation>Meldung %1 Beutel vor dem Ende</translation>
    </message>
    <message>
        <source>The run stops</source>
        <translation>Der Lauf hält an</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>good bags of an order</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>started by %1</source>
        <translation>begonnen von %1</translation>
    </message>
    <message>
        <source>first bag checked by %1</source>
        <translation>erster Beutel geprüft von %1</translation>
    </message>
    <message>
        <source>The lot has a character that nobody sees. Enter one line of visible characters.</source>
        <translation>Die Charge enthält ein unsichtbares Zeichen. Eine Zeile sichtbarer Zeichen eingeben.</translation>
    </message>
    <message>
        <source>The lot is too long: %1 bytes, at most %2 fit. A letter of another script has two or more.</source>
        <translation>Die Charge ist zu lang: %1 Bytes, höchstens %2 passen. Umlaute haben zwei Bytes, andere Schriften zwei oder mehr.</translation>
    </message>
    <message>
        <source>The text has a character that nobody sees. Enter one line of visible characters.</source>
        <translation>Der Text enthält ein unsichtbares Zeichen. Eine Zeile sichtbarer Zeichen eingeben.</translation>
    </message>
    <message>
        <source>The text is too long: %1 characters, at most %2 fit.</source>
        <translation>Der Text ist zu lang: %1 Zeichen, höchstens %2 passen.</translation>
    </message>
    <message>
        <source>This controller counts no orders: its register map is %1, orders need %2.</source>
        <translation>Diese Steuerung zählt keine Aufträge: Ihre Registerkarte ist %1, Aufträge brauchen %2.</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>%1 m of film</source>
        <translation>%1 m Folie</translation>
    </message>
</context>
<context>
    <name>PackageSentences</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 is not a Debian package.</source>
        <translation>%1 ist kein Debian-Paket.</translation>
    </message>
    <message>
        <source>%1 has no signature. Copy the file %1.sig beside it.</source>
        <translation>%1 hat keine Signatur. Kopieren Sie die Datei %1.sig daneben.</translation>
    </message>
    <message>
        <source>%1 is signed by %2, whose key this machine does not have. Install the key first.</source>
        <translation>%1 ist von %2 signiert, dessen Schlüssel diese Maschine nicht hat. Installieren Sie zuerst den Schlüssel.</translation>
    </message>
    <message>
        <source>%1 is signed by %2, whose key was withdrawn. Ask for a package signed with a valid key.</source>
        <translation>%1 ist von %2 signiert, dessen Schlüssel zurückgezogen wurde. Fordern Sie ein Paket mit einem gültigen Schlüssel an.</translation>
    </message>
    <message>
        <source>The signature of %1 is not valid. Ask for a new copy of both files.</source>
        <translation>Die Signatur von %1 ist ungültig. Fordern Sie beide Dateien neu an.</translation>
    </message>
    <message>
        <source>The signature of %1 has a newer form than this CamPanel knows. Install a version in between first.</source>
        <translation>Die Signatur von %1 hat eine neuere Form, als dieses CamPanel kennt. Installieren Sie zuerst eine Version dazwischen.</translation>
    </message>
    <message>
        <source>%1 is damaged or was changed after it was signed. Copy the file again.</source>
        <translation>%1 ist beschädigt oder wurde nach dem Signieren geändert. Kopieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>This package is for computers of type %1; this panel has %2.</source>
        <translation>Dieses Paket ist für Rechner vom Typ %1; dieses Panel hat %2.</translation>
    </message>
    <message>
        <source>Version %1 is older than the installed version %2.</source>
        <translation>Version %1 ist älter als die installierte Version %2.</translation>
    </message>
    <message>
        <source>Version %1 is installed.</source>
        <translation>Version %1 ist installiert.</translation>
    </message>
    <message>
        <source>not readable</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>no package</source>
        <translation>kein Paket</translation>
    </message>
    <message>
        <source>no signature</source>
        <translation>keine Signatur</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>withdrawn key</source>
        <translation>zurückgezogener Schlüssel</translation>
    </message>
    <message>
        <source>wrong signature</source>
        <translation>falsche Signatur</translation>
    </message>
    <message>
        <source>unknown form of signature</source>
        <translation>unbekannte Form der Signatur</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>for another type of computer</source>
        <translation>für anderen Rechnertyp</translation>
    </message>
    <message>
        <source>older version</source>
        <translation>ältere Version</translation>
    </message>
    <message>
        <source>installed</source>
        <translation>installiert</translation>
    </message>
    <message>
        <source>The package is not signed by a key of this machine.</source>
        <translation>Das Paket ist mit keinem Schlüssel dieser Maschine signiert.</translation>
    </message>
    <message>
        <source>The package is not a newer CamPanel for this machine.</source>
        <translation>Das Paket ist kein neueres CamPanel für diese Maschine.</translation>
    </message>
    <message>
        <source>The package needs other packages, which the stick cannot bring: %1. Install them by the package manager first.</source>
        <translation>Das Paket braucht weitere Pakete, die der Stick nicht bringen kann: %1. Installieren Sie diese zuerst mit der Paketverwaltung.</translation>
    </message>
    <message>
        <source>The package of the installed version %1 is missing, so there would be no way back. Copy it and its signature to the stick as well.</source>
        <translation>Das Paket der installierten Version %1 fehlt, es gäbe also keinen Weg zurück. Kopieren Sie es mit seiner Signatur ebenfalls auf den Stick.</translation>
    </message>
    <message>
        <source>%1 MB of free space are needed on this panel.</source>
        <translation>Auf diesem Panel werden %1 MB freier Platz gebraucht.</translation>
    </message>
    <message>
        <source>Another installation is under way on this panel. Wait until it has ended.</source>
        <translation>Auf diesem Panel läuft eine andere Installation. Warten Sie, bis sie beendet ist.</translation>
    </message>
    <message>
        <source>A program of the panel&apos;s user did not end. Switch the panel off and on, then try again.</source>
        <translation>Ein Programm des Panel-Benutzers hat sich nicht beendet. Schalten Sie das Panel aus und wieder ein, und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>The panel&apos;s data could not be copied. Read journalctl -u campanel-update.</source>
        <translation>Die Daten des Panels konnten nicht kopiert werden. Lesen Sie journalctl -u campanel-update.</translation>
    </message>
    <message>
        <source>The earlier version is not kept on this panel any more.</source>
        <translation>Die frühere Version ist auf diesem Panel nicht mehr vorhanden.</translation>
    </message>
    <message>
        <source>The new version did not open its window.</source>
        <translation>Die neue Version hat ihr Fenster nicht geöffnet.</translation>
    </message>
    <message>
        <source>The new version could not be installed.</source>
        <translation>Die neue Version ließ sich nicht installieren.</translation>
    </message>
    <message>
        <source>The files could not be read.</source>
        <translation>Die Dateien ließen sich nicht lesen.</translation>
    </message>
    <message>
        <source>This is the package %1; this panel takes %2.</source>
        <translation>Dies ist das Paket %1; dieses Panel nimmt %2.</translation>
    </message>
    <message>
        <source>another package</source>
        <translation>anderes Paket</translation>
    </message>
    <message>
        <source>The system is larger than its place on the card. Make a backup, then write the new image to the card.</source>
        <translation>Das System ist größer als sein Platz auf der Karte. Sichern Sie die Daten und schreiben Sie dann das neue Abbild auf die Karte.</translation>
    </message>
    <message>
        <source>The firmware of this computer cannot start a system once, so there would be no way back. Make a backup, then write the new image to the card.</source>
        <translation>Die Firmware dieses Computers kann ein System nicht nur einmal starten, es gäbe also keinen Weg zurück. Sichern Sie die Daten und schreiben Sie dann das neue Abbild auf die Karte.</translation>
    </message>
</context>
<context>
    <name>Protocol</name>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Reference run</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>Im Stillstand</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Pressen</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Rückhub</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Stop position outside tolerance</source>
        <translation>Endlage außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Force too low</source>
        <translation>Kraft zu klein</translation>
    </message>
    <message>
        <source>Force too high</source>
        <translation>Kraft zu groß</translation>
    </message>
    <message>
        <source>Contact too early</source>
        <translation>Kontakt zu früh</translation>
    </message>
    <message>
        <source>No contact</source>
        <translation>Kein Kontakt</translation>
    </message>
    <message>
        <source>Max. force reached</source>
        <translation>Max. Kraft erreicht</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Reset fault</source>
        <translation>Störung quittieren</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Measure marks</source>
        <translation>Marken messen</translation>
    </message>
    <message>
        <source>The lead of cam switch %1 is longer than a cycle. Shorten it under Maintenance, or lower the rate.</source>
        <translation>Die Vorhaltezeit von Nocken %1 ist länger als ein Zyklus. Unter Wartung verkürzen oder Taktzahl senken.</translation>
    </message>
    <message>
        <source>The controller does not support this command. Update its firmware.</source>
        <translation>Die Steuerung kennt diesen Befehl nicht. Ihre Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>Die Steuerung hat kein Programm. Zuerst ein Rezept laden.</translation>
    </message>
    <message>
        <source>The machine is already moving. Stop it first.</source>
        <translation>Die Maschine bewegt sich schon. Zuerst stoppen.</translation>
    </message>
    <message>
        <source>The machine is not running.</source>
        <translation>Die Maschine läuft nicht.</translation>
    </message>
    <message>
        <source>The controller is in fault. Reset the fault first.</source>
        <translation>Die Steuerung ist in Störung. Zuerst die Störung quittieren.</translation>
    </message>
    <message>
        <source>This is only possible at standstill. Stop the machine first.</source>
        <translation>Nur im Stillstand möglich. Zuerst die Maschine stoppen.</translation>
    </message>
    <message>
        <source>The controller has no checked table. Download again.</source>
        <translation>Die Steuerung hat keine geprüfte Tabelle. Erneut laden.</translation>
    </message>
    <message>
        <source>Another download interfered. Download again.</source>
        <translation>Ein anderes Laden kam dazwischen. Erneut laden.</translation>
    </message>
    <message>
        <source>The controller received different data. Download again.</source>
        <translation>Die Steuerung hat andere Daten empfangen. Erneut laden.</translation>
    </message>
    <message>
        <source>Machine data can only be changed at standstill. Stop the machine first.</source>
        <translation>Maschinendaten lassen sich nur im Stillstand ändern. Zuerst die Maschine stoppen.</translation>
    </message>
    <message>
        <source>No change is pending.</source>
        <translation>Es steht keine Änderung an.</translation>
    </message>
    <message>
        <source>Writing to the controller&apos;s flash failed; the saved program is unchanged. Save again.</source>
        <translation>Schreiben in den Flash-Speicher fehlgeschlagen; das gespeicherte Programm ist unverändert. Erneut speichern.</translation>
    </message>
    <message>
        <source>There is no fault to reset.</source>
        <translation>Es gibt keine Störung zu quittieren.</translation>
    </message>
    <message>
        <source>The controller does not accept this value. Update the older of panel and controller.</source>
        <translation>Die Steuerung nimmt diesen Wert nicht an. Das ältere Gerät, Panel oder Steuerung, aktualisieren.</translation>
    </message>
    <message>
        <source>The cause of the fault still exists. Remove it first.</source>
        <translation>Die Ursache der Störung besteht noch. Zuerst beseitigen.</translation>
    </message>
    <message>
        <source>The controller receives no heartbeat from the panel. Check the cable.</source>
        <translation>Die Steuerung erhält kein Lebenszeichen vom Panel. Kabel prüfen.</translation>
    </message>
    <message>
        <source>There are too many bags between mark sensor and knife. Set a longer bag, move the sensor closer, or switch off mark tracking under Maintenance.</source>
        <translation>Zwischen Markensensor und Messer liegen zu viele Beutel. Längeren Beutel einstellen, Sensor näher setzen oder Markenregelung unter Wartung ausschalten.</translation>
    </message>
    <message>
        <source>The mark window is wider than half a bag. Reduce it under Maintenance.</source>
        <translation>Das Markenfenster ist breiter als ein halber Beutel. Unter Wartung verkleinern.</translation>
    </message>
    <message>
        <source>The sync window is too long to correct the film. Change k1 to k4.</source>
        <translation>Der Synchronbereich ist zu lang, um die Folie zu korrigieren. k1 bis k4 ändern.</translation>
    </message>
    <message>
        <source>The product eye is too close or too far to decide in time. Check its distance under Maintenance.</source>
        <translation>Die Produktlichtschranke ist zu nah oder zu weit entfernt. Ihren Abstand unter Wartung prüfen.</translation>
    </message>
    <message>
        <source>Film or infeed would exceed the controller&apos;s speed limit. Lower the rate.</source>
        <translation>Folie oder Zuführung würde die Grenze der Steuerung überschreiten. Taktzahl senken.</translation>
    </message>
    <message>
        <source>Another device on the line writes parts of commands. Check the connected devices.</source>
        <translation>Ein anderes Gerät am Bus schreibt Teile von Befehlen. Angeschlossene Geräte prüfen.</translation>
    </message>
    <message>
        <source>The speed of an axis would change too abruptly. Stop the machine, then download; or raise the largest speed steps under Maintenance.</source>
        <translation>Eine Achse würde ihre Geschwindigkeit zu plötzlich ändern. Zuerst stoppen, dann laden; oder die größten Geschwindigkeitssprünge unter Wartung anheben.</translation>
    </message>
    <message>
        <source>Parts of the table are missing. Download again.</source>
        <translation>Teile der Tabelle fehlen. Erneut laden.</translation>
    </message>
    <message>
        <source>Panel and controller do not match. Update the older device.</source>
        <translation>Panel und Steuerung passen nicht zusammen. Das ältere Gerät aktualisieren.</translation>
    </message>
    <message>
        <source>Value %1 in the table header is outside the controller&apos;s limits. Correct the recipe.</source>
        <translation>Wert %1 im Tabellenkopf liegt außerhalb der Grenzen der Steuerung. Rezept korrigieren.</translation>
    </message>
    <message>
        <source>Row %1 of the table is outside the range of the controller&apos;s timer. Lower the rate.</source>
        <translation>Zeile %1 der Tabelle liegt außerhalb des Zeitgebers der Steuerung. Taktzahl senken.</translation>
    </message>
    <message>
        <source>The table&apos;s rows do not match its total pulses and time. Download again.</source>
        <translation>Die Zeilen der Tabelle passen nicht zu ihrer Pulszahl und Zeit. Erneut laden.</translation>
    </message>
    <message>
        <source>An earlier change is waiting for the end of the cycle. Cancel it first.</source>
        <translation>Eine frühere Änderung wartet auf das Ende des Zyklus. Zuerst abbrechen.</translation>
    </message>
    <message>
        <source>The controller has not finished checking or saving a table. Download again.</source>
        <translation>Die Steuerung hat das Prüfen oder Speichern einer Tabelle nicht beendet. Laden Sie erneut.</translation>
    </message>
    <message>
        <source>Mark tracking off</source>
        <translation>Markenregelung aus</translation>
    </message>
    <message>
        <source>Searching for marks</source>
        <translation>Sucht Druckmarken</translation>
    </message>
    <message>
        <source>Aligning cuts with marks</source>
        <translation>Richtet Schnitte an Marken aus</translation>
    </message>
    <message>
        <source>Tracking marks</source>
        <translation>Folgt den Druckmarken</translation>
    </message>
    <message>
        <source>Product in the knife&apos;s path</source>
        <translation>Produkt im Weg des Messers</translation>
    </message>
    <message>
        <source>Product longer than the bag</source>
        <translation>Produkt länger als der Beutel</translation>
    </message>
    <message>
        <source>Product missing</source>
        <translation>Produkt fehlt</translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation>unzulässige Funktion</translation>
    </message>
    <message>
        <source>illegal register address</source>
        <translation>unzulässige Registeradresse</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>unzulässiger Wert</translation>
    </message>
    <message>
        <source>device failure</source>
        <translation>Gerätefehler</translation>
    </message>
    <message>
        <source>acknowledged, in progress</source>
        <translation>bestätigt, in Arbeit</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>Gerät beschäftigt</translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation>Paritätsfehler im Speicher</translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation>Gateway-Pfad nicht verfügbar</translation>
    </message>
    <message>
        <source>no response from the device behind the gateway</source>
        <translation>keine Antwort vom Gerät hinter dem Gateway</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>By angle</source>
        <translation>Nach Winkel</translation>
    </message>
    <message>
        <source>Rejected bags</source>
        <translation>Ausschuss</translation>
    </message>
    <message>
        <source>Always on</source>
        <translation>Immer ein</translation>
    </message>
    <message>
        <source>While running</source>
        <translation>Im Lauf</translation>
    </message>
    <message>
        <source>Drive alarm</source>
        <translation>Alarm des Antriebs</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Limit switch, forward</source>
        <translation>Endschalter vorwärts</translation>
    </message>
    <message>
        <source>Limit switch, reverse</source>
        <translation>Endschalter rückwärts</translation>
    </message>
    <message>
        <source>Index mark</source>
        <translation>Nullmarke</translation>
    </message>
    <message>
        <source>Mark sensor</source>
        <translation>Markensensor</translation>
    </message>
    <message>
        <source>Product eye</source>
        <translation>Produktlichtschranke</translation>
    </message>
    <message>
        <source>Cam switch %1</source>
        <translation>Nocken %1</translation>
    </message>
    <message>
        <source>Drive enable</source>
        <translation>Antriebsfreigabe</translation>
    </message>
    <message>
        <source>following</source>
        <translation>folgt</translation>
    </message>
    <message>
        <source>decelerating</source>
        <translation>bremst</translation>
    </message>
    <message>
        <source>at standstill</source>
        <translation>im Stillstand</translation>
    </message>
    <message>
        <source>accelerating</source>
        <translation>beschleunigt</translation>
    </message>
    <message>
        <source>The emergency stop is pressed. Release it, then wait two seconds.</source>
        <translation>Der Not-Halt ist gedrückt. Entriegeln, dann zwei Sekunden warten.</translation>
    </message>
    <message>
        <source>The drive reported an alarm. Remove its cause, then reset the fault.</source>
        <translation>Der Antrieb meldete einen Alarm. Ursache beseitigen, dann Störung quittieren.</translation>
    </message>
    <message>
        <source>The panel does not permit the start: the machine is not warm. Wait until it is warm.</source>
        <translation>Das Panel gibt den Start nicht frei: Die Maschine ist nicht warm. Warten, bis sie warm ist.</translation>
    </message>
    <message>
        <source>The panel does not permit the start with this film reel. Load and scan the right reel.</source>
        <translation>Das Panel gibt den Start mit dieser Folienrolle nicht frei. Richtige Rolle einlegen und scannen.</translation>
    </message>
    <message>
        <source>The panel does not permit the start with this program. Download the recipe again.</source>
        <translation>Das Panel gibt den Start mit diesem Programm nicht frei. Rezept erneut herunterladen.</translation>
    </message>
    <message>
        <source>The panel does not permit motion while the machine is cleaned. End the cleaning first.</source>
        <translation>Das Panel gibt keine Bewegung frei, solange die Maschine gereinigt wird. Zuerst die Reinigung beenden.</translation>
    </message>
    <message>
        <source>The panel does not permit the start. Read the reason at its Start button.</source>
        <translation>Das Panel gibt den Start nicht frei. Grund an seiner Taste Start lesen.</translation>
    </message>
    <message>
        <source>NO contact</source>
        <translation>Schließer</translation>
    </message>
    <message>
        <source>NC contact</source>
        <translation>Öffner</translation>
    </message>
    <message>
        <source>The drive reports an alarm. The controller goes into fault.</source>
        <translation>Der Antrieb meldet einen Alarm. Die Steuerung geht in Störung.</translation>
    </message>
    <message>
        <source>Ends a motion and refuses others. No safety depends on this.</source>
        <translation>Beendet eine Bewegung und verweigert weitere. Keine Sicherheit hängt davon ab.</translation>
    </message>
    <message>
        <source>The axis is at its forward limit. Only displayed.</source>
        <translation>Die Achse ist am Endschalter vorwärts. Nur angezeigt.</translation>
    </message>
    <message>
        <source>The axis is at its reverse limit. Only displayed.</source>
        <translation>Die Achse ist am Endschalter rückwärts. Nur angezeigt.</translation>
    </message>
    <message>
        <source>The axis is on its index mark.</source>
        <translation>Die Achse steht auf ihrer Nullmarke.</translation>
    </message>
    <message>
        <source>A printed mark is under the sensor.</source>
        <translation>Eine Druckmarke ist unter dem Sensor.</translation>
    </message>
    <message>
        <source>A product covers the eye.</source>
        <translation>Ein Produkt verdeckt die Lichtschranke.</translation>
    </message>
    <message>
        <source>On by the angle of the cycle, or for a rejected bag.</source>
        <translation>Ein nach dem Winkel des Zyklus oder für einen Ausschussbeutel.</translation>
    </message>
    <message>
        <source>Enables the drives of all axes.</source>
        <translation>Gibt die Antriebe aller Achsen frei.</translation>
    </message>
    <message>
        <source>Try output</source>
        <translation>Ausgang testen</translation>
    </message>
    <message>
        <source>The distance in which prints behind a mark are ignored reaches the next mark. Reduce it under Maintenance.</source>
        <translation>Die hinter einer Marke ignorierte Folie reicht bis zur nächsten Marke. Unter Wartung verringern.</translation>
    </message>
    <message>
        <source>The minimum mark width is above the maximum. Correct it under Maintenance.</source>
        <translation>Die kleinste Markenbreite liegt über der größten. Unter Wartung korrigieren.</translation>
    </message>
    <message>
        <source>Torque limit</source>
        <translation>Momentgrenze</translation>
    </message>
    <message>
        <source>The drive is at its torque limit. While the jaws close, this is a jam.</source>
        <translation>Der Antrieb ist an seiner Momentgrenze. Während die Backen schließen, ist das eine Verklemmung.</translation>
    </message>
    <message>
        <source>The drive reports no torque</source>
        <translation>Der Antrieb meldet kein Moment</translation>
    </message>
    <message>
        <source>The drive reports its torque too seldom</source>
        <translation>Der Antrieb meldet sein Moment zu selten</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernt</translation>
    </message>
    <message>
        <source>Monitored</source>
        <translation>Überwacht</translation>
    </message>
    <message>
        <source>The angles at which the jaws touch the film leave out the cut. Enter both under Maintenance, or 0 for both.</source>
        <translation>Die Winkel, bei denen die Backen die Folie berühren, lassen den Schnitt aus. Unter Wartung beide eingeben, oder bei beiden 0.</translation>
    </message>
    <message>
        <source>The controller has no input for an encoder as the master. Set the clock as the master, or use another controller.</source>
        <translation>Die Steuerung hat keinen Eingang für einen Drehgeber als Leitachse. Den Takt als Leitachse einstellen oder eine andere Steuerung verwenden.</translation>
    </message>
    <message>
        <source>The line runs faster than this program. Slow it down, or download a faster program.</source>
        <translation>Die Linie läuft schneller als dieses Programm. Die Linie verlangsamen oder ein schnelleres Programm laden.</translation>
    </message>
    <message>
        <source>This program cannot follow an encoder. Set the clock as the master to run it.</source>
        <translation>Dieses Programm kann keinem Drehgeber folgen. Den Takt als Leitachse einstellen, um es zu starten.</translation>
    </message>
    <message>
        <source>Not engaged</source>
        <translation>Nicht eingekuppelt</translation>
    </message>
    <message>
        <source>Engaging</source>
        <translation>Kuppelt ein</translation>
    </message>
    <message>
        <source>Engaged</source>
        <translation>Eingekuppelt</translation>
    </message>
    <message>
        <source>Disengaging</source>
        <translation>Kuppelt aus</translation>
    </message>
    <message>
        <source>Line may run</source>
        <translation>Linie darf laufen</translation>
    </message>
    <message>
        <source>On while the knife follows the encoder on the film, or waits for it.</source>
        <translation>Ein, solange das Messer dem Drehgeber auf der Folie folgt oder auf ihn wartet.</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Messrad</translation>
    </message>
    <message>
        <source>A/B</source>
        <translation>A/B</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Takt</translation>
    </message>
    <message>
        <source>Start of an order</source>
        <translation>Beginn eines Auftrags</translation>
    </message>
    <message>
        <source>End of an order</source>
        <translation>Ende eines Auftrags</translation>
    </message>
    <message>
        <source>Another order is under way. End it first.</source>
        <translation>Ein anderer Auftrag läuft. Beenden Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>This order is not under way.</source>
        <translation>Dieser Auftrag läuft nicht.</translation>
    </message>
    <message>
        <source>No order</source>
        <translation>Kein Auftrag</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Vollständig</translation>
    </message>
    <message>
        <source>Ended early</source>
        <translation>Vorzeitig beendet</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>Weiterlaufen</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Start button</source>
        <translation>Starttaste</translation>
    </message>
    <message>
        <source>Starts a run when it is pressed, as Start on the panel does.</source>
        <translation>Startet beim Drücken einen Lauf, wie Start am Bedienpanel.</translation>
    </message>
    <message>
        <source>Stop button</source>
        <translation>Stopptaste</translation>
    </message>
    <message>
        <source>Ends a run at the end of its cycle and refuses a start.</source>
        <translation>Beendet einen Lauf am Zyklusende und verhindert einen Start.</translation>
    </message>
    <message>
        <source>Door open</source>
        <translation>Tür offen</translation>
    </message>
    <message>
        <source>Ends a run at once and refuses a start. No safety depends on this.</source>
        <translation>Beendet einen Lauf sofort und verhindert einen Start. Keine Sicherheitsfunktion.</translation>
    </message>
    <message>
        <source>Next machine not ready</source>
        <translation>Folgemaschine nicht bereit</translation>
    </message>
    <message>
        <source>Date coder not ready</source>
        <translation>Datumscodierer nicht bereit</translation>
    </message>
    <message>
        <source>On or blinking by the table of the light tower.</source>
        <translation>Nach der Tabelle der Signalsäule ein oder blinkend.</translation>
    </message>
    <message>
        <source>Light tower, red</source>
        <translation>Signalsäule, rot</translation>
    </message>
    <message>
        <source>Light tower, yellow</source>
        <translation>Signalsäule, gelb</translation>
    </message>
    <message>
        <source>Light tower, green</source>
        <translation>Signalsäule, grün</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>Hupe</translation>
    </message>
    <message>
        <source>Machine runs</source>
        <translation>Maschine läuft</translation>
    </message>
    <message>
        <source>On from the start of a run to its standstill.</source>
        <translation>Vom Start eines Laufs bis zum Stillstand eingeschaltet.</translation>
    </message>
    <message>
        <source>Acknowledgement</source>
        <translation>Quittierung</translation>
    </message>
    <message>
        <source>The Stop button of the machine is pressed. Release it.</source>
        <translation>Die Stopptaste der Maschine ist gedrückt. Taste lösen.</translation>
    </message>
    <message>
        <source>The door is open. Close it.</source>
        <translation>Die Tür ist offen. Tür schließen.</translation>
    </message>
    <message>
        <source>The next machine is not ready. Clear it first.</source>
        <translation>Die Folgemaschine ist nicht bereit. Zuerst dort die Ursache beheben.</translation>
    </message>
    <message>
        <source>The date coder is not ready. Clear its fault first.</source>
        <translation>Der Datumscodierer ist nicht bereit. Zuerst seine Störung beheben.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>Blinkt</translation>
    </message>
    <message>
        <source>Blinks, then on</source>
        <translation>Blinkt, dann ein</translation>
    </message>
    <message>
        <source>On, then off</source>
        <translation>Ein, dann aus</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Order complete</source>
        <translation>Auftrag fertig</translation>
    </message>
    <message>
        <source>One-bag button</source>
        <translation>Taste für einen Beutel</translation>
    </message>
    <message>
        <source>Makes one bag when it is pressed at standstill.</source>
        <translation>Macht beim Drücken im Stillstand einen Beutel.</translation>
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
        <source>The active program makes no bags. Download a cutter&apos;s program to a packing machine first.</source>
        <translation>Das aktive Programm macht keine Beutel. Laden Sie zuerst das Programm eines Schneiders auf eine Packmaschine.</translation>
    </message>
    <message>
        <source>The knife is not in its place. Make a reference run first.</source>
        <translation>Das Messer ist nicht an seinem Platz. Zuerst eine Referenzfahrt machen.</translation>
    </message>
    <message>
        <source>The line in front drives the film, so no single bag can be made.</source>
        <translation>Die Linie davor treibt die Folie an; ein einzelner Beutel ist nicht möglich.</translation>
    </message>
    <message>
        <source>The film moves. Stop the line first.</source>
        <translation>Die Folie bewegt sich. Zuerst die Linie stoppen.</translation>
    </message>
    <message>
        <source>No cam switch rejects bags. Set one under Maintenance.</source>
        <translation>Kein Nocken wirft Beutel aus. Einen unter Wartung einstellen.</translation>
    </message>
    <message>
        <source>A product is under the knife. Run the machine empty first.</source>
        <translation>Unter dem Messer liegt ein Produkt. Die Maschine zuerst leer fahren.</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>Startbereit</translation>
    </message>
    <message>
        <source>On at standstill while nothing refuses a start.</source>
        <translation>Ein im Stillstand, solange nichts gegen einen Start spricht.</translation>
    </message>
    <message>
        <source>Product request</source>
        <translation>Produktanforderung</translation>
    </message>
    <message>
        <source>On in a run while the place at the product eye is free.</source>
        <translation>Ein während des Laufs, solange der Platz an der Produktlichtschranke frei ist.</translation>
    </message>
    <message>
        <source>Date coder pulse</source>
        <translation>Impuls für den Datumscodierer</translation>
    </message>
    <message>
        <source>One pulse for each product, at its place before the cut.</source>
        <translation>Ein Impuls für jedes Produkt, an seiner Stelle vor dem Schnitt.</translation>
    </message>
    <message>
        <source>The date coder prints before the products are on the film. Check the place of its pulse under Maintenance &gt; Inputs and outputs.</source>
        <translation>Der Datumscodierer druckt, bevor die Produkte auf der Folie liegen. Prüfen Sie die Stelle seines Impulses unter Wartung &gt; Ein- und Ausgänge.</translation>
    </message>
    <message>
        <source>Film index</source>
        <translation>Index der Folie</translation>
    </message>
    <message>
        <source>On once per turn of the film motor. For measuring it.</source>
        <translation>Einmal je Umdrehung des Folienmotors ein. Zum Messen.</translation>
    </message>
    <message>
        <source>Infeed index</source>
        <translation>Index der Zuführung</translation>
    </message>
    <message>
        <source>On once per product of the infeed. For measuring it.</source>
        <translation>Einmal je Produkt der Zuführung ein. Zum Messen.</translation>
    </message>
    <message>
        <source>Measurement of an axis</source>
        <translation>Messung einer Achse</translation>
    </message>
    <message>
        <source>This axis has no index sensor. Connect one under Maintenance &gt; Inputs and outputs, or enter the pulses by hand.</source>
        <translation>Diese Achse hat keinen Indexsensor. Schließen Sie einen unter Wartung &gt; Ein- und Ausgänge an, oder geben Sie die Pulse von Hand ein.</translation>
    </message>
    <message>
        <source>No index mark came within four turns. Check the index sensor.</source>
        <translation>Innerhalb von vier Umdrehungen kam keine Indexmarke. Prüfen Sie den Indexsensor.</translation>
    </message>
    <message>
        <source>The jaws hold the film. Jog the knife open first.</source>
        <translation>Die Backen halten die Folie. Öffnen Sie zuerst das Messer im Tippbetrieb.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>In a given time</source>
        <translation>In gegebener Zeit</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>So schnell wie möglich</translation>
    </message>
    <message>
        <source>Over a distance</source>
        <translation>Über einen Weg</translation>
    </message>
    <message>
        <source>Cam points</source>
        <translation>Kurvenpunkte</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Natürlich</translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation>Eingespannt</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>Periodisch</translation>
    </message>
    <message>
        <source>Trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>S curve</source>
        <translation>S-Kurve</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Gentle</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>Cool</source>
        <translation>Kühl</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Dazwischen</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>Execution</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>Shape of the ramp</source>
        <translation>Form der Rampe</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Verhältnisse</translation>
    </message>
    <message>
        <source>Spline ends</source>
        <translation>Spline-Enden</translation>
    </message>
    <message>
        <source>Rotary cutter</source>
        <translation>Querschneider</translation>
    </message>
    <message>
        <source>Position move</source>
        <translation>Positionierung</translation>
    </message>
    <message>
        <source>Speed move</source>
        <translation>Geschw.-Wechsel</translation>
    </message>
    <message>
        <source>Point cam</source>
        <translation>Punktkurve</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Presse</translation>
    </message>
    <message>
        <source>Segment cam</source>
        <translation>Abschnittskurve</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Stützpunkte</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Exponent k</source>
        <translation>Exponent k</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps to its peak (6) at both ends; as a speed law, jerk does.</source>
        <translation>Als Bewegungsgesetz springt an beiden Enden die Beschleunigung auf ihren Höchstwert (6), als Bewegungsgesetz der Ruck.</translation>
    </message>
    <message>
        <source>Quintic 3-4-5</source>
        <translation>Polynom 3-4-5</translation>
    </message>
    <message>
        <source>Speed and acceleration are zero at both ends, with a short polynomial.</source>
        <translation>Geschwindigkeit und Beschleunigung sind an beiden Enden null, mit kurzem Polynom.</translation>
    </message>
    <message>
        <source>Polynomial 4-5-6-7</source>
        <translation>Polynom 4-5-6-7</translation>
    </message>
    <message>
        <source>Speed, acceleration and jerk are zero at both ends, which excites little vibration.</source>
        <translation>Geschwindigkeit, Beschleunigung und Ruck sind an beiden Enden null: wenig Schwingung.</translation>
    </message>
    <message>
        <source>This law has the highest peak speed (2.19) and peak acceleration (7.51) of the displacement laws without parameters.</source>
        <translation>Höchste Geschwindigkeit (2,19) und Beschleunigung (7,51) der Bewegungsgesetze ohne Parameter.</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>Einfache Sinuslinie</translation>
    </message>
    <message>
        <source>Half a cosine wave gives a low peak speed (1.57) and a low peak acceleration (4.93).</source>
        <translation>Eine halbe Kosinuswelle ergibt kleine Geschwindigkeit (1,57) und Beschleunigung (4,93).</translation>
    </message>
    <message>
        <source>As a displacement law, full acceleration at start and end causes jolts.</source>
        <translation>Als Bewegungsgesetz stößt die volle Beschleunigung am Anfang und am Ende.</translation>
    </message>
    <message>
        <source>Cycloidal</source>
        <translation>Geneigte Sinuslinie</translation>
    </message>
    <message>
        <source>Acceleration is one full sine wave: smooth, and zero at both ends.</source>
        <translation>Die Beschleunigung ist eine volle Sinuswelle: glatt und an beiden Enden null.</translation>
    </message>
    <message>
        <source>Peak speed (2) and peak acceleration (6.28) are high, and jerk jumps at both ends.</source>
        <translation>Geschwindigkeit (2) und Beschleunigung (6,28) sind hoch, der Ruck springt an beiden Enden.</translation>
    </message>
    <message>
        <source>Modified sine</source>
        <translation>Mod. Sinuslinie</translation>
    </message>
    <message>
        <source>Jerk jumps at both ends and has the highest finite peak (69.5) of the laws without parameters.</source>
        <translation>Der Ruck springt an beiden Enden und hat den höchsten endlichen Wert (69,5) der Gesetze ohne Parameter.</translation>
    </message>
    <message>
        <source>Modified trapezoid</source>
        <translation>Mod. Beschl.-Trapez</translation>
    </message>
    <message>
        <source>This law has the lowest peak acceleration (4.89) of the laws without parameters and acceleration jumps.</source>
        <translation>Kleinste Höchstbeschleunigung (4,89) der Gesetze ohne Parameter und ohne Beschleunigungssprung.</translation>
    </message>
    <message>
        <source>Peak speed (2) and peak jerk (61.4) are high, and jerk jumps at both ends.</source>
        <translation>Geschwindigkeit (2) und Ruck (61,4) sind hoch, der Ruck springt an beiden Enden.</translation>
    </message>
    <message>
        <source>Parabolic</source>
        <translation>Quadratische Parabel</translation>
    </message>
    <message>
        <source>This law has the lowest possible peak acceleration (4) from rest to rest.</source>
        <translation>Kleinste mögliche Höchstbeschleunigung (4) von Rast zu Rast.</translation>
    </message>
    <message>
        <source>At the same peak acceleration, no law has a lower peak speed; the ramp fraction trades one for the other.</source>
        <translation>Bei gleicher Beschleunigung hat kein Gesetz eine kleinere Geschwindigkeit; der Rampenanteil tauscht eins gegen das andere.</translation>
    </message>
    <message>
        <source>Seven-segment S</source>
        <translation>S-Kurve, 7 Abschnitte</translation>
    </message>
    <message>
        <source>Acceleration does not jump; the peaks of acceleration and jerk can be set.</source>
        <translation>Die Beschleunigung springt nicht; die Höchstwerte von Beschleunigung und Ruck sind einstellbar.</translation>
    </message>
    <message>
        <source>Exponential</source>
        <translation>Exponentiell</translation>
    </message>
    <message>
        <source>Acceleration is highest at low speed, where the motor has the most torque, and lowest near the end speed.</source>
        <translation>Die Beschleunigung ist groß bei kleiner Drehzahl, wo der Motor das größte Moment hat, und klein nahe der Endgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Acceleration jumps at both ends; a larger k increases the jump at the low speed.</source>
        <translation>Die Beschleunigung springt an beiden Enden; größeres k vergrößert den Sprung bei kleiner Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Half modified sine</source>
        <translation>Halbe mod. Sinuslinie</translation>
    </message>
    <message>
        <source>Acceleration is zero at both ends and peaks at only 1.57 times its mean.</source>
        <translation>Die Beschleunigung ist an beiden Enden null und höchstens das 1,57-Fache des Mittels.</translation>
    </message>
    <message>
        <source>Ramp fraction r</source>
        <translation>Rampenanteil r</translation>
    </message>
    <message>
        <source>Jerk share q</source>
        <translation>Ruckanteil q</translation>
    </message>
    <message>
        <source>Bag length</source>
        <translation>Beutellänge</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Taktzahl</translation>
    </message>
    <message>
        <source>Base speed v_a</source>
        <translation>Grundgeschw. v_a</translation>
    </message>
    <message>
        <source>Film speed v_b</source>
        <translation>Foliengeschw. v_b</translation>
    </message>
    <message>
        <source>Ratio k1</source>
        <translation>Verh. k1</translation>
    </message>
    <message>
        <source>Ratio k2</source>
        <translation>Verh. k2</translation>
    </message>
    <message>
        <source>Ratio k3</source>
        <translation>Verh. k3</translation>
    </message>
    <message>
        <source>Ratio k4</source>
        <translation>Verh. k4</translation>
    </message>
    <message>
        <source>Sync ratio</source>
        <translation>Synchronverhältnis</translation>
    </message>
    <message>
        <source>Slices per ramp</source>
        <translation>Teilschritte/Rampe</translation>
    </message>
    <message>
        <source>Knife radius R</source>
        <translation>Messerradius R</translation>
    </message>
    <message>
        <source>Distance from the shaft&apos;s center to the knife edge: half of the diameter measured at the edge. All knife speeds refer to the edge.</source>
        <translation>Abstand von der Wellenmitte zur Messerschneide: der halbe an der Schneide gemessene Durchmesser. Alle Messergeschwindigkeiten gelten an der Schneide.</translation>
    </message>
    <message>
        <source>Knives N</source>
        <translation>Messerzahl N</translation>
    </message>
    <message>
        <source>Number of knives on the shaft, evenly spaced. Each bag turns the shaft by one knife.</source>
        <translation>Anzahl der gleichmäßig verteilten Messer auf der Welle. Jeder Beutel dreht die Welle um ein Messer weiter.</translation>
    </message>
    <message>
        <source>Pulses per motor rev. K</source>
        <translation>Pulse/Motorumdr. K</translation>
    </message>
    <message>
        <source>Pulses per motor revolution, as set in the servo drive&apos;s electronic gear. A wrong value makes all bags too long or too short.</source>
        <translation>Pulse je Motorumdrehung laut elektronischem Getriebe des Servoantriebs. Ein falscher Wert macht alle Beutel zu lang oder zu kurz.</translation>
    </message>
    <message>
        <source>Gear Z, motor revs</source>
        <translation>Getriebe Z, Motor</translation>
    </message>
    <message>
        <source>Motor revolutions for the knife shaft revolutions below, see the gear&apos;s nameplate: 7 and 3 for a gear of 7:3.</source>
        <translation>Motorumdrehungen für die Umdrehungen der Messerwelle darunter, siehe Typenschild: 7 und 3 bei einem Getriebe 7:3.</translation>
    </message>
    <message>
        <source>Gear Z, knife revs</source>
        <translation>Getriebe Z, Messer</translation>
    </message>
    <message>
        <source>Knife shaft revolutions for the motor revolutions above.</source>
        <translation>Umdrehungen der Messerwelle für die Motorumdrehungen darüber.</translation>
    </message>
    <message>
        <source>Max. motor speed</source>
        <translation>Max. Motordrehzahl</translation>
    </message>
    <message>
        <source>Maximum motor speed, see the motor&apos;s nameplate. No recipe exceeds this speed.</source>
        <translation>Höchste Motordrehzahl, siehe Typenschild des Motors. Kein Rezept überschreitet sie.</translation>
    </message>
    <message>
        <source>Max. acceleration</source>
        <translation>Max. Beschleunigung</translation>
    </message>
    <message>
        <source>Maximum acceleration without vibration or loss of position. Start with a low value, and raise it as the following error allows.</source>
        <translation>Höchste Beschleunigung ohne Schwingung und ohne Positionsverlust. Klein beginnen und erhöhen, soweit der Schleppfehler es erlaubt.</translation>
    </message>
    <message>
        <source>Max. pulse frequency</source>
        <translation>Max. Pulsfrequenz</translation>
    </message>
    <message>
        <source>Maximum pulse frequency of the drive&apos;s input, see its manual. The controller has its own limit.</source>
        <translation>Höchste Pulsfrequenz am Eingang des Antriebs, siehe sein Handbuch. Die Steuerung hat ihre eigene Grenze.</translation>
    </message>
    <message>
        <source>Max. rate</source>
        <translation>Max. Taktzahl</translation>
    </message>
    <message>
        <source>Maximum rate that sealing time and infeed allow, independent of the knife.</source>
        <translation>Höchste Taktzahl, die Siegelzeit und Zuführung unabhängig vom Messer erlauben.</translation>
    </message>
    <message>
        <source>Timer clock</source>
        <translation>Zeitgebertakt</translation>
    </message>
    <message>
        <source>Timer width</source>
        <translation>Zeitgeberbreite</translation>
    </message>
    <message>
        <source>Rows in the controller</source>
        <translation>Zeilen der Steuerung</translation>
    </message>
    <message>
        <source>Feed per motor rev.</source>
        <translation>Vorschub/Motorumdr.</translation>
    </message>
    <message>
        <source>Travel of the axis per motor revolution, including gear and spindle.</source>
        <translation>Weg der Achse je Motorumdrehung, mit Getriebe und Spindel.</translation>
    </message>
    <message>
        <source>Max. motor torque</source>
        <translation>Max. Motormoment</translation>
    </message>
    <message>
        <source>Peak torque of the motor, see the motor&apos;s nameplate. 0: unknown, no limit.</source>
        <translation>Spitzenmoment des Motors, siehe Typenschild. 0: unbekannt, keine Grenze.</translation>
    </message>
    <message>
        <source>Inertia at the motor</source>
        <translation>Trägheit am Motor</translation>
    </message>
    <message>
        <source>Total inertia of motor, gear and load at the motor. CamPanel uses the inertia to estimate the torque of a motion. 0: unknown.</source>
        <translation>Gesamte Trägheit von Motor, Getriebe und Last am Motor. CamPanel schätzt daraus das Moment einer Bewegung. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Friction at the motor</source>
        <translation>Reibung am Motor</translation>
    </message>
    <message>
        <source>Friction torque at the motor while the axis turns slowly and steadily.</source>
        <translation>Reibmoment am Motor, während die Achse langsam und gleichmäßig dreht.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Start speed</source>
        <translation>Anfangsgeschw.</translation>
    </message>
    <message>
        <source>End speed</source>
        <translation>Endgeschw.</translation>
    </message>
    <message>
        <source>Table intervals</source>
        <translation>Tabellenschritte</translation>
    </message>
    <message>
        <source>Master speed</source>
        <translation>Leitgeschw.</translation>
    </message>
    <message>
        <source>Master ramp</source>
        <translation>Leitrampe</translation>
    </message>
    <message>
        <source>Master revs/cycle</source>
        <translation>Leitumdr./Zyklus</translation>
    </message>
    <message>
        <source>Master scale</source>
        <translation>Leitskalierung</translation>
    </message>
    <message>
        <source>Slave scale</source>
        <translation>Folgeskalierung</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Approach to</source>
        <translation>Anfahren bis</translation>
    </message>
    <message>
        <source>Approach speed</source>
        <translation>Anfahrgeschw.</translation>
    </message>
    <message>
        <source>Probe speed</source>
        <translation>Tastgeschw.</translation>
    </message>
    <message>
        <source>Probe force</source>
        <translation>Tastkraft</translation>
    </message>
    <message>
        <source>Contact before</source>
        <translation>Kontakt vor</translation>
    </message>
    <message>
        <source>Press speed</source>
        <translation>Pressgeschw.</translation>
    </message>
    <message>
        <source>Press to</source>
        <translation>Pressen bis</translation>
    </message>
    <message>
        <source>Hold time</source>
        <translation>Haltezeit</translation>
    </message>
    <message>
        <source>Return speed</source>
        <translation>Rückhubgeschw.</translation>
    </message>
    <message>
        <source>Max. force</source>
        <translation>Max. Kraft</translation>
    </message>
    <message>
        <source>Stop tolerance</source>
        <translation>Endlagentoleranz</translation>
    </message>
    <message>
        <source>Min. force at stop</source>
        <translation>Min. Kraft am Ende</translation>
    </message>
    <message>
        <source>Max. force at stop</source>
        <translation>Max. Kraft am Ende</translation>
    </message>
    <message>
        <source>Jaw contact angle</source>
        <translation>Kontaktwinkel Backen</translation>
    </message>
    <message>
        <source>Angle of the knife shaft over which the sealing jaws touch the film: their arc divided by the knife radius. 0 is a thin knife, without checks of window and seal time.</source>
        <translation>Winkel der Messerwelle, über den die Siegelbacken die Folie berühren: ihr Bogen durch den Messerradius. 0 ist ein dünnes Messer, ohne Prüfung von Bereich und Siegelzeit.</translation>
    </message>
    <message>
        <source>Min. seal time</source>
        <translation>Min. Siegelzeit</translation>
    </message>
    <message>
        <source>Minimum time of the jaws on the film, see the film&apos;s data sheet. The panel limits the rate accordingly. The controller does not store this value. 0: no minimum.</source>
        <translation>Kleinste Zeit der Backen auf der Folie, siehe Datenblatt der Folie. Das Panel begrenzt damit die Taktzahl. Die Steuerung speichert den Wert nicht. 0: kein Mindestwert.</translation>
    </message>
    <message>
        <source>Ramps, slow to gentle</source>
        <translation>Rampen, langsam bis sanft</translation>
    </message>
    <message>
        <source>Rated motor torque</source>
        <translation>Nennmoment Motor</translation>
    </message>
    <message>
        <source>Continuous torque of the motor, see the motor&apos;s nameplate. The RMS torque of a cycle stays below it. 0: unknown, no limit.</source>
        <translation>Dauermoment des Motors, siehe Typenschild. Das Effektivmoment eines Zyklus bleibt darunter. 0: unbekannt, keine Grenze.</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>Eigenfrequenz</translation>
    </message>
    <message>
        <source>Lowest natural frequency of the shaft behind the motor, from a measurement or the drive&apos;s analysis. 0: unknown.</source>
        <translation>Kleinste Eigenfrequenz der Welle hinter dem Motor, aus einer Messung oder der Analyse des Antriebs. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>Damping of this vibration as a share of critical damping. 0.05 is usual for a shaft with gear.</source>
        <translation>Dämpfung dieser Schwingung als Anteil der kritischen Dämpfung. 0,05 ist für eine Welle mit Getriebe üblich.</translation>
    </message>
    <message>
        <source>knife speed</source>
        <translation>Messergeschwindigkeit</translation>
    </message>
    <message>
        <source>knife stroke</source>
        <translation>Messerhub</translation>
    </message>
    <message>
        <source>motor speed</source>
        <translation>Motordrehzahl</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>pulse frequency</source>
        <translation>Pulsfrequenz</translation>
    </message>
    <message>
        <source>max. rate</source>
        <translation>max. Taktzahl</translation>
    </message>
    <message>
        <source>table rows</source>
        <translation>Tabellenzeilen</translation>
    </message>
    <message>
        <source>motor torque</source>
        <translation>Motormoment</translation>
    </message>
    <message>
        <source>sync window</source>
        <translation>Synchronbereich</translation>
    </message>
    <message>
        <source>seal time</source>
        <translation>Siegelzeit</translation>
    </message>
    <message>
        <source>RMS torque</source>
        <translation>Effektivmoment</translation>
    </message>
    <message>
        <source>natural frequency</source>
        <translation>Eigenfrequenz</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Rast</translation>
    </message>
    <message>
        <source>Constant speed</source>
        <translation>Gleichförmig</translation>
    </message>
    <message>
        <source>Polynomial 3, with speeds</source>
        <translation>Polynom 3, mit Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Polynomial 5, with speeds and accelerations</source>
        <translation>Polynom 5, mit Geschw. und Beschl.</translation>
    </message>
    <message>
        <source>As a speed law, acceleration is zero at both ends and peaks at only 1.5 times its mean.</source>
        <translation>Als Bewegungsgesetz ist die Beschleunigung an beiden Enden null und höchstens das 1,5-Fache des Mittels.</translation>
    </message>
    <message>
        <source>Jerk jumps at both ends; a trapezoid with ramps above 22.29 % of the move needs less peak acceleration.</source>
        <translation>Der Ruck springt an beiden Enden; ein Trapez mit Rampen über 22,29 % des Wegs braucht weniger Beschleunigung.</translation>
    </message>
    <message>
        <source>Low peak speed (1.76), moderate peak acceleration (5.53) and continuous acceleration suit large inertia.</source>
        <translation>Kleine Geschwindigkeit (1,76), mäßige Beschleunigung (5,53) ohne Sprung passen zu großer Trägheit.</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps at both ends and in the middle, and peak speed (2) is high.</source>
        <translation>Als Bewegungsgesetz springt die Beschleunigung an den Enden und in der Mitte; die Geschwindigkeit (2) ist hoch.</translation>
    </message>
    <message>
        <source>As a displacement law, acceleration jumps at both ends of both ramps, so jerk is unbounded.</source>
        <translation>Als Bewegungsgesetz springt die Beschleunigung an beiden Enden beider Rampen; der Ruck ist unbegrenzt.</translation>
    </message>
    <message>
        <source>Jerk jumps at every joint of the segments; a smaller jerk share means a higher jerk.</source>
        <translation>Der Ruck springt an jeder Naht der Abschnitte; kleinerer Ruckanteil heißt größerer Ruck.</translation>
    </message>
    <message>
        <source>The law is not symmetric: from rest, the travel is 0.568 of end speed times time; jerk jumps at both ends.</source>
        <translation>Das Gesetz ist unsymmetrisch: aus dem Stand ist der Weg 0,568 mal Endgeschwindigkeit mal Zeit; der Ruck springt an beiden Enden.</translation>
    </message>
</context>
<context>
    <name>RecipeComparison</name>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Program type</source>
        <translation>Programmart</translation>
    </message>
    <message>
        <source>Pinned values</source>
        <translation>Feste Werte</translation>
    </message>
    <message>
        <source>Law parameter 1</source>
        <translation>Parameter 1 des Gesetzes</translation>
    </message>
    <message>
        <source>Law parameter 2</source>
        <translation>Parameter 2 des Gesetzes</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Film reel</source>
        <translation>Folienrolle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Confirmed advance</source>
        <translation>Bestätigter Vorschub</translation>
    </message>
    <message>
        <source>%1 per cycle</source>
        <translation>%1 je Zyklus</translation>
    </message>
    <message>
        <source>Trim: %1</source>
        <translation>Trimm: %1</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <comment>name of a value</comment>
        <translation>Freigegeben: %1</translation>
    </message>
</context>
<context>
    <name>RecipeWords</name>
    <message>
        <source>bags/min</source>
        <translation>Beutel/min</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>Pulse</translation>
    </message>
    <message>
        <source>%1 segments</source>
        <translation>%1 Abschnitte</translation>
    </message>
    <message>
        <source>1 segment</source>
        <translation>1 Abschnitt</translation>
    </message>
    <message>
        <source>%1 knots</source>
        <translation>%1 Stützpunkte</translation>
    </message>
    <message>
        <source>Bag %1</source>
        <comment>name of a recipe, length in mm</comment>
        <translation>Beutel %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Impulse</translation>
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
        <translation>Innerhalb aller Grenzen.</translation>
    </message>
    <message>
        <source>Within all limits. Possible up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>Innerhalb aller Grenzen. Möglich bis %1 (%2).</translation>
    </message>
    <message>
        <source>Just within the limits.</source>
        <translation>Knapp innerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>Just within the limits. Possible up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>Knapp innerhalb der Grenzen. Möglich bis %1 (%2).</translation>
    </message>
    <message>
        <source>Motor speed would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Die Motordrehzahl erreicht %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Knife acceleration would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Die Messerbeschleunigung erreicht %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Pulse frequency would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Die Pulsfrequenz erreicht %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>%1 is required; the machine&apos;s limit is %2.</source>
        <translation>%1 wird gebraucht; die Grenze der Maschine ist %2.</translation>
    </message>
    <message>
        <source>%1 has no value. Enter %2 to %3.</source>
        <translation>%1 hat keinen Wert. %2 bis %3 eingeben.</translation>
    </message>
    <message>
        <source>%1 would be %2; the allowed range is %3 to %4.</source>
        <translation>%1 wäre %2; erlaubt ist %3 bis %4.</translation>
    </message>
    <message>
        <source>Pin two of bag length, rate, base speed and film speed.</source>
        <translation>Zwei von Beutellänge, Taktzahl, Grund- und Foliengeschwindigkeit festhalten.</translation>
    </message>
    <message>
        <source>This speed law is unknown. Choose another law.</source>
        <translation>Dieses Bewegungsgesetz ist unbekannt. Ein anderes wählen.</translation>
    </message>
    <message>
        <source>%1 is %2; the nearest possible value is %3.</source>
        <translation>%1 ist %2; der nächste mögliche Wert ist %3.</translation>
    </message>
    <message>
        <source>The ratios must descend from k1 to k4: %1 is %2 and must be below %3.</source>
        <translation>Die Verhältnisse müssen von k1 bis k4 fallen: %1 ist %2 und muss unter %3 liegen.</translation>
    </message>
    <message>
        <source>A bag of %1 exceeds the knife stroke; with these ratios the maximum is %2.</source>
        <translation>Ein Beutel von %1 überschreitet den Messerhub; mit diesen Verhältnissen ist %2 das Maximum.</translation>
    </message>
    <message>
        <source>The table needs %1 rows, the controller has %2. Use fewer slices per ramp.</source>
        <translation>Die Tabelle braucht %1 Zeilen, die Steuerung hat %2. Weniger Teilschritte je Rampe wählen.</translation>
    </message>
    <message>
        <source>A cycle has only %1 pulses. Check pulses per revolution, gear and knives.</source>
        <translation>Ein Zyklus hat nur %1 Pulse. Pulse je Umdrehung, Getriebe und Messer prüfen.</translation>
    </message>
    <message>
        <source>Motor speed would reach %1 at %3 s; the limit is %2.</source>
        <translation>Die Motordrehzahl erreicht %1 bei %3 s; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Acceleration would reach %1 at %3 s; the limit is %2.</source>
        <translation>Die Beschleunigung erreicht %1 bei %3 s; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Motor torque would reach %1 at %3 s; the limit is %2.</source>
        <translation>Das Motormoment erreicht %1 bei %3 s; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Following the master would require %1 at %3 s; the limit is %2.</source>
        <translation>Der Leitachse zu folgen erfordert %1 bei %3 s; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Pulse frequency would reach %1 at %3 s; the limit is %2.</source>
        <translation>Die Pulsfrequenz erreicht %1 bei %3 s; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>The cam has %1 knots; the nearest possible number is %2.</source>
        <translation>Die Kurve hat %1 Stützpunkte; die nächste mögliche Zahl ist %2.</translation>
    </message>
    <message>
        <source>Knot %1 at %2 must come after the previous knot at %3.</source>
        <translation>Stützpunkt %1 bei %2 muss nach dem vorigen bei %3 liegen.</translation>
    </message>
    <message>
        <source>Knot %1 is only %2 after the previous knot; the minimum is %3.</source>
        <translation>Stützpunkt %1 liegt nur %2 nach dem vorigen; das Minimum ist %3.</translation>
    </message>
    <message>
        <source>Knot %1 at %2 is out of range; the nearest position is %3.</source>
        <translation>Stützpunkt %1 bei %2 liegt außerhalb des Bereichs; die nächste Position ist %3.</translation>
    </message>
    <message>
        <source>Knot %1 is at %2; the cam needs a knot at %3.</source>
        <translation>Stützpunkt %1 liegt bei %2; die Kurve braucht einen Stützpunkt bei %3.</translation>
    </message>
    <message>
        <source>Near knot %1 the curve reaches %2, beyond the end of the knots&apos; range at %3. Move the knot or add another knot.</source>
        <translation>Bei Stützpunkt %1 erreicht die Kurve %2, über das Ende des Bereichs bei %3 hinaus. Stützpunkt verschieben oder einen weiteren einfügen.</translation>
    </message>
    <message>
        <source>Speed jumps by %1 at the end of the cycle. Choose periodic ends.</source>
        <translation>Die Geschwindigkeit springt am Ende des Zyklus um %1. Periodische Enden wählen.</translation>
    </message>
    <message>
        <source>%1 is %2, which gives no motion. Enter another value.</source>
        <translation>%1 ist %2; das ergibt keine Bewegung. Anderen Wert eingeben.</translation>
    </message>
    <message>
        <source>These speeds require at least %1, not %2.</source>
        <translation>Diese Geschwindigkeiten erfordern mindestens %1, nicht %2.</translation>
    </message>
    <message>
        <source>The distance %1 and the speeds have opposite directions. Change the sign of the distance.</source>
        <translation>Der Weg %1 und die Geschwindigkeiten sind entgegengesetzt. Vorzeichen des Wegs ändern.</translation>
    </message>
    <message>
        <source>%1 %2 must be beyond %3.</source>
        <translation>%1 %2 muss jenseits von %3 liegen.</translation>
    </message>
    <message>
        <source>%1 %2 must be at most %3.</source>
        <translation>%1 %2 darf höchstens %3 sein.</translation>
    </message>
    <message>
        <source>The table exceeds the controller&apos;s range. Use fewer pulses per revolution or a shorter motion.</source>
        <translation>Die Tabelle überschreitet den Bereich der Steuerung. Weniger Pulse je Umdrehung oder eine kürzere Bewegung wählen.</translation>
    </message>
    <message>
        <source>%1 needs a ramp of %2 ms at maximum acceleration; the controller allows %3 ms. Enter a lower speed or a higher acceleration.</source>
        <translation>%1 braucht bei höchster Beschleunigung eine Rampe von %2 ms; die Steuerung erlaubt %3 ms. Kleinere Geschwindigkeit oder größere Beschleunigung eingeben.</translation>
    </message>
    <message>
        <source>The motion reverses, but intervals run in one direction. Choose cam points.</source>
        <translation>Die Bewegung kehrt um, Schritte laufen aber in eine Richtung. Kurvenpunkte wählen.</translation>
    </message>
    <message>
        <source>With whole pulses, a speed error of %1 is not possible, but %2 is. Use more pulses per revolution.</source>
        <translation>Mit ganzen Pulsen ist ein Geschwindigkeitsfehler von %1 nicht möglich, aber %2. Mehr Pulse je Umdrehung verwenden.</translation>
    </message>
    <message>
        <source>The motion has too few pulses for intervals. Use more pulses per revolution.</source>
        <translation>Die Bewegung hat zu wenige Pulse für Schritte. Mehr Pulse je Umdrehung verwenden.</translation>
    </message>
    <message>
        <source>Acceleration would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Die Beschleunigung erreicht %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Motor torque would reach %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Das Motormoment erreicht %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>Following the master would require %1 at %3 s (%4°); the limit is %2.</source>
        <translation>Der Leitachse zu folgen erfordert %1 bei %3 s (%4°); die Grenze ist %2.</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 Nearest possible value: %2.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Nächster möglicher Wert: %2.</translation>
    </message>
    <message>
        <source>Widen the window, %1</source>
        <comment>%1: rate with unit</comment>
        <translation>Bereich erweitern, %1</translation>
    </message>
    <message>
        <source>Widen the window</source>
        <translation>Bereich erweitern</translation>
    </message>
    <message>
        <source>Ratios %1</source>
        <translation>Verhältnisse %1</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <comment>%1: ratios, %2: rate</comment>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>The jaws need a sync window of %2° of the knife; at %3 s (%4°) the window has only %1°.</source>
        <translation>Die Backen brauchen einen Synchronbereich von %2° des Messers; bei %3 s (%4°) hat er nur %1°.</translation>
    </message>
    <message>
        <source>Seal time would be %1 at %3 s (%4°); the film needs %2.</source>
        <translation>Die Siegelzeit wäre %1 bei %3 s (%4°); die Folie braucht %2.</translation>
    </message>
    <message>
        <source>The film needs a seal time of %1, but the machine has no contact angle of the jaws. Enter the angle in Settings, Machine.</source>
        <translation>Die Folie braucht eine Siegelzeit von %1, aber der Kontaktwinkel der Backen fehlt. Unter Einstellungen, Maschine eingeben.</translation>
    </message>
    <message>
        <source>Longer ramps</source>
        <translation>Längere Rampen</translation>
    </message>
    <message>
        <source>Shorter ramps</source>
        <translation>Kürzere Rampen</translation>
    </message>
    <message>
        <source>%1 %2 allow %3.</source>
        <comment>%1: whole sentence, %2: longer ramps, %3: rate with unit</comment>
        <translation>%1 %2 erlauben %3.</translation>
    </message>
    <message>
        <source>RMS torque would be %1, and the motor would overheat; its rated torque is %2.</source>
        <translation>Das Effektivmoment wäre %1, der Motor würde überhitzen; sein Nennmoment ist %2.</translation>
    </message>
    <message>
        <source>The cycle repeats at %1, above the shaft&apos;s natural frequency of %2. Enter a lower rate, or correct the machine data.</source>
        <translation>Der Zyklus wiederholt sich mit %1, über der Eigenfrequenz der Welle von %2. Taktzahl senken oder Maschinendaten korrigieren.</translation>
    </message>
    <message>
        <source>This motion allows up to %1 (%2).</source>
        <comment>%1: rate with unit, %2: name of the limit</comment>
        <translation>Diese Bewegung erlaubt bis zu %1 (%2).</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>number, number with unit</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 %2, approved %3</source>
        <comment>name, value, window</comment>
        <translation>%1 %2, freigegeben %3</translation>
    </message>
</context>
<context>
    <name>RegisterWords</name>
    <message>
        <source>Identity</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>Austausch</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Command result</source>
        <translation>Befehlsergebnis</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>Transfer result</source>
        <translation>Übertragungsergebnis</translation>
    </message>
    <message>
        <source>Read-back</source>
        <translation>Rücklesen</translation>
    </message>
    <message>
        <source>Read-back result</source>
        <translation>Rückleseergebnis</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>Aktives Programm</translation>
    </message>
    <message>
        <source>Staged program</source>
        <translation>Bereitgestelltes Programm</translation>
    </message>
    <message>
        <source>Read only: the panel writes this register with every status request.</source>
        <translation>Nur lesbar: das Panel schreibt dieses Register mit jeder Statusanfrage.</translation>
    </message>
    <message>
        <source>Read only: the command keys write this register, each command once and with its own counter.</source>
        <translation>Nur lesbar: die Befehlstasten schreiben dieses Register, jeden Befehl einmal und mit eigenem Zähler.</translation>
    </message>
    <message>
        <source>Read only: written by downloads.</source>
        <translation>Nur lesbar: wird beim Laden geschrieben.</translation>
    </message>
    <message>
        <source>Read only: the panel uses this register to read other registers.</source>
        <translation>Nur lesbar: das Panel liest damit andere Register.</translation>
    </message>
    <message>
        <source>Read only: changed by a program download.</source>
        <translation>Nur lesbar: ändert sich beim Laden eines Programms.</translation>
    </message>
    <message>
        <source>Read only: set by the panel after connecting.</source>
        <translation>Nur lesbar: vom Panel nach dem Verbinden gesetzt.</translation>
    </message>
    <message>
        <source>Read only: only the controller writes this register.</source>
        <translation>Nur lesbar: nur die Steuerung schreibt dieses Register.</translation>
    </message>
    <message>
        <source>%1 cannot be %2; the allowed range is %3 to %4. Enter another value.</source>
        <comment>%1: register</comment>
        <translation>%1 kann nicht %2 sein; erlaubt ist %3 bis %4. Anderen Wert eingeben.</translation>
    </message>
</context>
<context>
    <name>RunSentences</name>
    <message>
        <source>Reading the program of the controller …</source>
        <translation>Liest das Programm der Steuerung …</translation>
    </message>
    <message>
        <source>The controller has lost its program: the program was not saved before the restart. Download again.</source>
        <translation>Die Steuerung hat ihr Programm verloren: Es war vor dem Neustart nicht gespeichert. Erneut laden.</translation>
    </message>
    <message>
        <source>The controller has no program yet. Download one on the Motion page.</source>
        <translation>Die Steuerung hat noch kein Programm. Auf der Seite Bewegung eines laden.</translation>
    </message>
    <message>
        <source>No connection. New bags are not shown.</source>
        <translation>Keine Verbindung. Neue Beutel werden nicht angezeigt.</translation>
    </message>
    <message>
        <source>Searching for marks: the bags are scrap</source>
        <translation>Sucht Druckmarken: Die Beutel sind Ausschuss</translation>
    </message>
    <message>
        <source>Aligning with the marks: the bags are scrap</source>
        <translation>Richtet an den Marken aus: Die Beutel sind Ausschuss</translation>
    </message>
    <message>
        <source>Running; first bag not measured yet</source>
        <translation>Läuft; erster Beutel noch nicht gemessen</translation>
    </message>
    <message>
        <source>No bag measured yet. Press Start.</source>
        <translation>Noch kein Beutel gemessen. Start drücken.</translation>
    </message>
    <message>
        <source>No bag measured yet.</source>
        <translation>Noch kein Beutel gemessen.</translation>
    </message>
    <message>
        <source>Mark tracking off</source>
        <translation>Markenregelung aus</translation>
    </message>
    <message>
        <source>Marks not searched for yet</source>
        <translation>Druckmarken noch nicht gesucht</translation>
    </message>
    <message>
        <source>Searching for marks</source>
        <translation>Sucht Druckmarken</translation>
    </message>
    <message>
        <source>No marks found</source>
        <translation>Keine Druckmarken gefunden</translation>
    </message>
    <message>
        <source>Tracking marks</source>
        <translation>Folgt den Druckmarken</translation>
    </message>
    <message>
        <source>Changing to the new program</source>
        <translation>Wechselt auf das neue Programm</translation>
    </message>
    <message>
        <source>Film waits for a product</source>
        <translation>Folie wartet auf ein Produkt</translation>
    </message>
    <message>
        <source>Knife stays open: product in its path</source>
        <translation>Messer bleibt offen: Produkt im Weg</translation>
    </message>
    <message>
        <source>No stroke yet. Press Start.</source>
        <translation>Noch kein Hub. Start drücken.</translation>
    </message>
    <message>
        <source>No stroke yet.</source>
        <translation>Noch kein Hub.</translation>
    </message>
    <message>
        <source>Aligning cuts with marks</source>
        <translation>Richtet Schnitte an Marken aus</translation>
    </message>
    <message>
        <source>Cuts not aligned with marks yet</source>
        <translation>Schnitte noch nicht ausgerichtet</translation>
    </message>
    <message>
        <source>No bag measured yet. Hold Start.</source>
        <translation>Noch kein Beutel gemessen. Start gedrückt halten.</translation>
    </message>
    <message>
        <source>No stroke yet. Hold Start.</source>
        <translation>Noch kein Hub. Start gedrückt halten.</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Hold Start, or choose other curves with Curves.</source>
        <translation>Noch keine Daten dieser Kurven. Start gedrückt halten oder mit Kurven andere wählen.</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Press Start, or choose other curves with Curves.</source>
        <translation>Noch keine Daten dieser Kurven. Start drücken oder mit Kurven andere wählen.</translation>
    </message>
    <message>
        <source>There are no data of these curves yet. Choose other curves with Curves.</source>
        <translation>Noch keine Daten dieser Kurven. Mit Kurven andere wählen.</translation>
    </message>
    <message>
        <source>Downloaded. The machine is running this recipe.</source>
        <translation>Geladen. Die Maschine läuft mit diesem Rezept.</translation>
    </message>
    <message>
        <source>Downloaded. Hold Start to run this recipe.</source>
        <translation>Geladen. Start gedrückt halten, um dieses Rezept auszuführen.</translation>
    </message>
    <message>
        <source>Downloaded. Press Start to run this recipe.</source>
        <translation>Geladen. Start drücken, um dieses Rezept auszuführen.</translation>
    </message>
    <message>
        <source>Downloaded. The controller has this recipe.</source>
        <translation>Geladen. Die Steuerung hat dieses Rezept.</translation>
    </message>
    <message>
        <source>Threading up: no bags before a mark is at the knife</source>
        <translation>Einfädeln: keine Beutel, bevor eine Marke am Messer ist</translation>
    </message>
    <message>
        <source>Knife stays open while the film is threaded up</source>
        <translation>Messer bleibt offen, solange die Folie eingefädelt wird</translation>
    </message>
</context>
<context>
    <name>SegmentSentences</name>
    <message>
        <source>Segment %1 begins at %2, which is out of range; the nearest possible value is %3.</source>
        <translation>Abschnitt %1 beginnt bei %2, außerhalb des Bereichs; der nächste mögliche Wert ist %3.</translation>
    </message>
    <message>
        <source>Segment %1 has a boundary speed of %2; the nearest possible value is %3.</source>
        <translation>Abschnitt %1 hat eine Randgeschwindigkeit von %2; der nächste mögliche Wert ist %3.</translation>
    </message>
    <message>
        <source>Segment %1 has a boundary acceleration of %2; the nearest possible value is %3.</source>
        <translation>Abschnitt %1 hat eine Randbeschleunigung von %2; der nächste mögliche Wert ist %3.</translation>
    </message>
    <message>
        <source>Segment %1 ends at %2, which is out of range; the nearest possible value is %3.</source>
        <translation>Abschnitt %1 endet bei %2, außerhalb des Bereichs; der nächste mögliche Wert ist %3.</translation>
    </message>
    <message>
        <source>The cam has %1 segments; the nearest possible number is %2.</source>
        <translation>Die Kurve hat %1 Abschnitte; die nächste mögliche Zahl ist %2.</translation>
    </message>
    <message>
        <source>Segment %1 is only %2 wide; the minimum is %3.</source>
        <translation>Abschnitt %1 ist nur %2 breit; das Minimum ist %3.</translation>
    </message>
    <message>
        <source>Segment %1 begins at %2 and overlaps the segment before it, which ends at %3. Begin it at %3.</source>
        <translation>Abschnitt %1 beginnt bei %2 und überlappt den vorigen, der bei %3 endet. Beginn auf %3 setzen.</translation>
    </message>
    <message>
        <source>Segment %1 begins at %2 and leaves a gap: the segment before it ends at %3. Begin it at %3.</source>
        <translation>Abschnitt %1 beginnt bei %2 und lässt eine Lücke: der vorige endet bei %3. Beginn auf %3 setzen.</translation>
    </message>
    <message>
        <source>The first segment begins at %1; the cycle begins at %2.</source>
        <translation>Der erste Abschnitt beginnt bei %1; der Zyklus beginnt bei %2.</translation>
    </message>
    <message>
        <source>The last segment ends at %1; the cycle ends at %2.</source>
        <translation>Der letzte Abschnitt endet bei %1; der Zyklus endet bei %2.</translation>
    </message>
    <message>
        <source>The motion of segment %1 is unknown. Choose another motion.</source>
        <translation>Die Bewegung von Abschnitt %1 ist unbekannt. Andere Bewegung wählen.</translation>
    </message>
    <message>
        <source>Segment %1: %2 is %3; the nearest possible value is %4.</source>
        <translation>Abschnitt %1: %2 ist %3; der nächste mögliche Wert ist %4.</translation>
    </message>
    <message>
        <source>Speed jumps by %1 at the end of the cycle; the axis can follow %2. Make the segments continuous.</source>
        <translation>Die Geschwindigkeit springt am Ende des Zyklus um %1; die Achse kann %2 folgen. Abschnitte stetig machen.</translation>
    </message>
    <message>
        <source>Speed jumps by %1 where segment %2 begins; the axis can follow %3. Make the segments continuous.</source>
        <translation>Die Geschwindigkeit springt am Anfang von Abschnitt %2 um %1; die Achse kann %3 folgen. Abschnitte stetig machen.</translation>
    </message>
    <message>
        <source>Where segment %1 begins: speed jumps by %2, acceleration by %3.</source>
        <translation>Am Anfang von Abschnitt %1 springt die Geschwindigkeit um %2, die Beschleunigung um %3.</translation>
    </message>
    <message>
        <source>The segments are continuous.</source>
        <translation>Die Abschnitte sind stetig.</translation>
    </message>
    <message>
        <source>At the end of the cycle: speed jumps by %1, acceleration by %2.</source>
        <translation>Am Ende des Zyklus springt die Geschwindigkeit um %1, die Beschleunigung um %2.</translation>
    </message>
</context>
<context>
    <name>StopWords</name>
    <message>
        <source>Waiting for products</source>
        <translation>Warten auf Produkte</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Film change</source>
        <translation>Folienwechsel</translation>
    </message>
    <message>
        <source>Film torn</source>
        <translation>Folie gerissen</translation>
    </message>
    <message>
        <source>No product</source>
        <translation>Kein Produkt</translation>
    </message>
    <message>
        <source>Product jam</source>
        <translation>Produktstau</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Film jam</source>
        <translation>Folienstau</translation>
    </message>
    <message>
        <source>Knife, jaws</source>
        <translation>Messer, Backen</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>Siegelnaht</translation>
    </message>
    <message>
        <source>Bag length</source>
        <translation>Beutellänge</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Changeover</source>
        <translation>Umrüsten</translation>
    </message>
    <message>
        <source>Cleaning</source>
        <translation>Reinigung</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>Wartung</translation>
    </message>
    <message>
        <source>Break</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>No order</source>
        <translation>Kein Auftrag</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>No reason</source>
        <translation>Ohne Grund</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>title and code of an alarm</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>group and reason</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>Short stops (up to %1)</source>
        <translation>Kurze Stillstände (bis %1)</translation>
    </message>
    <message>
        <source>%1 · %2×</source>
        <comment>duration, number of stops</comment>
        <translation>%1 · %2×</translation>
    </message>
</context>
<context>
    <name>StoreErrorText</name>
    <message>
        <source>the folder cannot be created</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 cannot be opened: %2. Check the disk and its permissions.</source>
        <translation>Die Datenbank %1 lässt sich nicht öffnen: %2. Datenträger und Rechte prüfen.</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 was written by a newer version of CamPanel. Install that version.</source>
        <translation>Die Datenbank %1 stammt von einer neueren Version von CamPanel. Diese Version installieren.</translation>
    </message>
    <message>
        <source>The disk is full; data saved before are kept. Free some disk space and save again.</source>
        <translation>Der Datenträger ist voll; früher gespeicherte Daten bleiben. Platz schaffen und erneut speichern.</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is write-protected. Check the disk and its permissions.</source>
        <translation>Die Datenbank %1 ist schreibgeschützt. Datenträger und Rechte prüfen.</translation>
    </message>
    <message>
        <source>The panel&apos;s database did not accept the data: %1.</source>
        <translation>Die Datenbank hat die Daten nicht angenommen: %1.</translation>
    </message>
    <message>
        <source>The records of bags and trends were damaged; new records were started. The damaged file was saved as %1.</source>
        <translation>Die Aufzeichnung der Beutel und Trends war beschädigt; eine neue wurde begonnen. Die beschädigte Datei liegt unter %1.</translation>
    </message>
    <message>
        <source>this user does not exist</source>
        <translation>diesen Benutzer gibt es nicht</translation>
    </message>
    <message>
        <source>at least one user of the level Service must remain</source>
        <translation>mindestens ein Benutzer der Stufe Service muss bleiben</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>this file does not exist</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is damaged. Restart the panel to use the last good copy, if there is one.</source>
        <translation>Die Datenbank %1 ist beschädigt. Panel neu starten, um die letzte gute Kopie zu verwenden, falls vorhanden.</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 is in use by another program. Close that program, then restart the panel.</source>
        <translation>Die Datenbank %1 ist von einem anderen Programm belegt. Dieses schließen, dann das Panel neu starten.</translation>
    </message>
    <message>
        <source>The users and PINs of this panel are lost; only operators can work. To start without PINs, delete the file %1, restart the panel and restore a backup.</source>
        <translation>Benutzer und PINs dieses Panels sind verloren; nur Bediener können arbeiten. Für einen Beginn ohne PINs die Datei %1 löschen, das Panel neu starten und eine Sicherung zurückspielen.</translation>
    </message>
    <message>
        <source>The panel&apos;s database %1 was altered by another program: %2 is not of CamPanel. Move the file away, restart the panel and restore a backup.</source>
        <translation>Die Datenbank %1 wurde von einem anderen Programm verändert: %2 ist nicht von CamPanel. Die Datei wegräumen, das Panel neu starten und eine Sicherung zurückspielen.</translation>
    </message>
    <message>
        <source>The recipe %1 has the last version number and was not saved. Save it under another name.</source>
        <translation>Das Rezept %1 hat die letzte Versionsnummer und wurde nicht gespeichert. Unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>a name has visible characters only, and at least one</source>
        <translation>ein Name hat nur sichtbare Zeichen und mindestens eines</translation>
    </message>
    <message>
        <source>The disk with the panel&apos;s data cannot be used: %1. Replace the disk and restore a backup.</source>
        <translation>Der Datenträger mit den Daten des Panels ist nicht nutzbar: %1. Datenträger tauschen und eine Sicherung zurückspielen.</translation>
    </message>
</context>
<context>
    <name>TableText</name>
    <message>
        <source>Step table</source>
        <translation>Schritttabelle</translation>
    </message>
    <message>
        <source>Cam points</source>
        <translation>Kurvenpunkte</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Press stages</source>
        <translation>Pressstufen</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Time s</source>
        <translation>Zeit s</translation>
    </message>
    <message>
        <source>Frequency Hz</source>
        <translation>Frequenz Hz</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Pulse</translation>
    </message>
    <message>
        <source>Timer ticks</source>
        <translation>Zeitgeberschritte</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Slope pulses</source>
        <translation>Steigung, Pulse</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Start Hz</source>
        <translation>Anfang Hz</translation>
    </message>
    <message>
        <source>End Hz</source>
        <translation>Ende Hz</translation>
    </message>
    <message>
        <source>Hz/s</source>
        <translation>Hz/s</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Speed Hz</source>
        <translation>Geschw. Hz</translation>
    </message>
    <message>
        <source>End pulses</source>
        <translation>Endpulse</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>Kraft N</translation>
    </message>
    <message>
        <source>Time ms</source>
        <translation>Zeit ms</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>accel.</source>
        <translation>beschl.</translation>
    </message>
    <message>
        <source>decel.</source>
        <translation>bremsen</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>sync</source>
        <translation>synchron</translation>
    </message>
    <message>
        <source>%1 rows, %2 pulses per cycle, %3 s</source>
        <translation>%1 Zeilen, %2 Pulse je Zyklus, %3 s</translation>
    </message>
    <message>
        <source>Max. speed error: %1 (%2 %) at %3 s</source>
        <translation>Max. Geschwindigkeitsfehler: %1 (%2 %) bei %3 s</translation>
    </message>
    <message>
        <source>Max. frequency step: %1 Hz at %2 s</source>
        <translation>Max. Frequenzstufe: %1 Hz bei %2 s</translation>
    </message>
    <message>
        <source>Max. position error: %1 pulses between rows, %2 inside</source>
        <translation>Max. Positionsfehler: %1 Pulse zwischen den Zeilen, %2 in der Zeile</translation>
    </message>
    <message>
        <source>Drift: none; the pulse remainder is carried over to the next cycle</source>
        <translation>Drift: keine; der Pulsrest geht in den nächsten Zyklus über</translation>
    </message>
    <message>
        <source>%1 points, %2 pulses per cycle, %3 s</source>
        <translation>%1 Punkte, %2 Pulse je Zyklus, %3 s</translation>
    </message>
    <message>
        <source>Max. position error between points: %1 pulses (%2) at %3 s</source>
        <translation>Max. Positionsfehler zwischen Punkten: %1 Pulse (%2) bei %3 s</translation>
    </message>
    <message>
        <source>Max. speed error: %1 at %2 s</source>
        <translation>Max. Geschwindigkeitsfehler: %1 bei %2 s</translation>
    </message>
    <message>
        <source>%1 intervals, %2 pulses, %3 s instead of %4 s</source>
        <translation>%1 Schritte, %2 Pulse, %3 s statt %4 s</translation>
    </message>
    <message>
        <source>Max. speed error: %1 at %2 s, position: %3 pulses</source>
        <translation>Max. Geschwindigkeitsfehler: %1 bei %2 s, Position: %3 Pulse</translation>
    </message>
    <message>
        <source>%1 stages; the pulse generator counts the last section, %2 per pulse</source>
        <translation>%1 Stufen; der Pulsgeber zählt den letzten Abschnitt, %2 je Puls</translation>
    </message>
    <message>
        <source>Error of the paper&apos;s rounding rule: %1 pulses (%2) per bag</source>
        <translation>Fehler der Rundungsregel des Aufsatzes: %1 Pulse (%2) je Beutel</translation>
    </message>
</context>
<context>
    <name>TrimWords</name>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produkt</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>%1 earlier</source>
        <translation>%1 früher</translation>
    </message>
    <message>
        <source>%1 later</source>
        <translation>%1 später</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>%1 back</source>
        <translation>%1 zurück</translation>
    </message>
    <message>
        <source>%1 forward</source>
        <translation>%1 vor</translation>
    </message>
    <message>
        <source>Shorter</source>
        <translation>Kürzer</translation>
    </message>
    <message>
        <source>Longer</source>
        <translation>Länger</translation>
    </message>
    <message>
        <source>%1 shorter</source>
        <translation>%1 kürzer</translation>
    </message>
    <message>
        <source>%1 longer</source>
        <translation>%1 länger</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Access</name>
    <message>
        <source>A name has 1 to %1 characters.</source>
        <translation>Ein Name hat 1 bis %1 Zeichen.</translation>
    </message>
    <message>
        <source>This name is already in use.</source>
        <translation>Diesen Namen gibt es schon.</translation>
    </message>
    <message>
        <source>There is not enough memory to store a PIN safely. Restart the panel.</source>
        <translation>Der Speicher reicht nicht, um eine PIN sicher abzulegen. Panel neu starten.</translation>
    </message>
    <message>
        <source>%1 can log in now.</source>
        <translation>%1 kann sich jetzt anmelden.</translation>
    </message>
    <message>
        <source>%1 has a new PIN.</source>
        <translation>%1 hat eine neue PIN.</translation>
    </message>
    <message>
        <source>%1 now has the level %2.</source>
        <translation>%1 hat jetzt die Stufe %2.</translation>
    </message>
    <message>
        <source>%1 can no longer log in.</source>
        <translation>%1 kann sich nicht mehr anmelden.</translation>
    </message>
    <message>
        <source>At least one user of the level Service must remain.</source>
        <translation>Mindestens ein Benutzer der Stufe Service muss bleiben.</translation>
    </message>
    <message>
        <source>The name has characters that nobody can see. Enter the name again.</source>
        <translation>Der Name enthält unsichtbare Zeichen. Den Namen neu eingeben.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmDetail</name>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>This alarm was logged by a newer panel version.</source>
        <translation>Dieser Alarm stammt von einer neueren Panel-Version.</translation>
    </message>
    <message>
        <source>still active</source>
        <translation>noch aktiv</translation>
    </message>
    <message>
        <source>unknown: the panel was off or the controller was changed</source>
        <translation>unbekannt: das Panel war aus oder die Steuerung wurde getauscht</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>not required</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>time, person</comment>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmHistory</name>
    <message>
        <source>alarms</source>
        <translation>Alarme</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AlarmWatch</name>
    <message>
        <source>Axis: following error %1 pulses, limit %2 pulses</source>
        <translation>Achse: Schleppfehler %1 Pulse, Grenze %2 Pulse</translation>
    </message>
    <message>
        <source>Axis: following error %1 pulses</source>
        <translation>Achse: Schleppfehler %1 Pulse</translation>
    </message>
    <message>
        <source>Ram: force %1 N, limit %2 N</source>
        <translation>Stößel: Kraft %1 N, Grenze %2 N</translation>
    </message>
    <message>
        <source>Ram: contact at %1, approach ends at %2</source>
        <translation>Stößel: Kontakt bei %1, Anfahren endet bei %2</translation>
    </message>
    <message>
        <source>Dead time of the mark sensor: entered %1 ms, learned %2 ms, margin ±%3 ms</source>
        <translation>Totzeit des Markensensors: eingegeben %1 ms, gelernt %2 ms, Unsicherheit ±%3 ms</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Audit</name>
    <message>
        <source>Checking the audit trail …</source>
        <translation>Das Protokoll wird geprüft …</translation>
    </message>
    <message>
        <source>Not checked yet.</source>
        <translation>Noch nicht geprüft.</translation>
    </message>
    <message>
        <source>audit trail</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>All users</source>
        <translation>Alle Benutzer</translation>
    </message>
    <message>
        <source>Row and time</source>
        <translation>Zeile und Zeit</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Requested</source>
        <translation>Verlangt</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Rückgelesen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>Hash</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AxisFields</name>
    <message>
        <source>Main motor: reversed</source>
        <translation>Hauptmotor: umgekehrt</translation>
    </message>
    <message>
        <source>Film motor: reversed</source>
        <translation>Folienmotor: umgekehrt</translation>
    </message>
    <message>
        <source>Infeed motor: reversed</source>
        <translation>Zuführmotor: umgekehrt</translation>
    </message>
    <message>
        <source>Film motor: pulses per revolution</source>
        <translation>Folienmotor: Pulse je Umdrehung</translation>
    </message>
    <message>
        <source>Film motor: film per revolution</source>
        <translation>Folienmotor: Folie je Umdrehung</translation>
    </message>
    <message>
        <source>Infeed motor: pulses per product</source>
        <translation>Zuführmotor: Pulse je Produkt</translation>
    </message>
    <message>
        <source>Film motor: index sensor</source>
        <translation>Folienmotor: Indexsensor</translation>
    </message>
    <message>
        <source>Infeed motor: index sensor</source>
        <translation>Zuführmotor: Indexsensor</translation>
    </message>
    <message>
        <source>This controller cannot turn a motor the other way. Set the direction at the drive.</source>
        <translation>Diese Steuerung kann keinen Motor umkehren. Stellen Sie die Richtung am Antrieb ein.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::AxisMeasurement</name>
    <message>
        <source>No data of the axes. Connect the controller.</source>
        <translation>Keine Daten der Achsen. Verbinden Sie die Steuerung.</translation>
    </message>
    <message>
        <source>This controller cannot measure its axes. Update the controller: its register map must be 1.7 or newer.</source>
        <translation>Diese Steuerung kann ihre Achsen nicht messen. Aktualisieren Sie die Steuerung: Ihre Registertabelle muss 1.7 oder neuer sein.</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1 Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Pulses per turn of the main motor</source>
        <translation>Pulse je Umdrehung des Hauptmotors</translation>
    </message>
    <message>
        <source>The measurement was stopped.</source>
        <translation>Die Messung wurde gestoppt.</translation>
    </message>
    <message>
        <source>The connection was lost during the measurement. The controller stops the axis.</source>
        <translation>Die Verbindung brach während der Messung ab. Die Steuerung hält die Achse an.</translation>
    </message>
    <message>
        <source>Length of the last bag by the ruler</source>
        <translation>Länge des letzten Beutels nach dem Lineal</translation>
    </message>
    <message>
        <source>The machine data could not be changed now.</source>
        <translation>Die Maschinendaten ließen sich jetzt nicht ändern.</translation>
    </message>
    <message>
        <source>%1 instead of %2 is in the machine data now. Download the recipe to use it.</source>
        <translation>%1 statt %2 steht jetzt in den Maschinendaten. Laden Sie das Rezept, damit es gilt.</translation>
    </message>
    <message>
        <source>The direction is right. Nothing was changed.</source>
        <translation>Die Richtung stimmt. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The motor turns the other way now. Measure its direction again, then save.</source>
        <translation>Der Motor dreht jetzt anders herum. Messen Sie die Richtung noch einmal, dann speichern Sie.</translation>
    </message>
    <message>
        <source>%1 instead of %2 is in the controller now. Save it there.</source>
        <translation>%1 statt %2 steht jetzt in der Steuerung. Speichern Sie den Wert dort.</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>As wired</source>
        <translation>Wie verdrahtet</translation>
    </message>
    <message>
        <source>%1 pulses</source>
        <translation>%1 Pulse</translation>
    </message>
    <message>
        <source>The controller knows no bag yet. Make one bag twice, or let the machine run, then measure the last bag with a ruler.</source>
        <translation>Die Steuerung kennt noch keinen Beutel. Machen Sie zweimal einen Beutel, oder lassen Sie die Maschine laufen; messen Sie dann den letzten Beutel mit einem Lineal.</translation>
    </message>
    <message>
        <source>By the present setting bag %1 is %2 long. Measure it with a ruler and enter its length, %3 to %4: a bag that is farther off is another one.</source>
        <translation>Nach der jetzigen Einstellung ist Beutel %1 %2 lang. Messen Sie ihn mit einem Lineal und geben Sie seine Länge ein, %3 bis %4: Ein Beutel, der weiter abweicht, ist ein anderer.</translation>
    </message>
    <message>
        <source>Keep hands away: the axis turns slowly by a quarter of a turn, forward. Watch which way.</source>
        <translation>Hände weg: Die Achse dreht sich langsam eine Viertelumdrehung vorwärts. Beobachten Sie, in welche Richtung.</translation>
    </message>
    <message>
        <source>Keep hands away and take the film out of the jaws: the axis turns slowly forward, past five index marks. The controller counts its pulses.</source>
        <translation>Hände weg, und nehmen Sie die Folie aus den Backen: Die Achse dreht sich langsam vorwärts, an fünf Indexmarken vorbei. Die Steuerung zählt ihre Pulse.</translation>
    </message>
    <message>
        <source>Keep hands away: the film motor turns slowly forward, past five index marks. The controller counts its pulses.</source>
        <translation>Hände weg: Der Folienmotor dreht sich langsam vorwärts, an fünf Indexmarken vorbei. Die Steuerung zählt seine Pulse.</translation>
    </message>
    <message>
        <source>Keep hands away: the infeed moves slowly forward by five products. The controller counts its pulses.</source>
        <translation>Hände weg: Die Zuführung bewegt sich langsam um fünf Produkte vorwärts. Die Steuerung zählt ihre Pulse.</translation>
    </message>
    <message>
        <source>The turns differ by %1 pulses, too much. Check the index sensor, then measure again.</source>
        <translation>Die Umdrehungen unterscheiden sich um %1 Pulse, zu viel. Prüfen Sie den Indexsensor, dann messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The measured value is outside the range of the setting. Check the sensor and the bag.</source>
        <translation>Der Messwert liegt außerhalb des Bereichs der Einstellung. Prüfen Sie Sensor und Beutel.</translation>
    </message>
    <message>
        <source>The bag is %1 by the ruler and %2 by the setting.</source>
        <translation>Der Beutel ist nach dem Lineal %1 und nach der Einstellung %2 lang.</translation>
    </message>
    <message>
        <source>Five turns, which differ by %1 pulses.</source>
        <translation>Fünf Umdrehungen, die sich um %1 Pulse unterscheiden.</translation>
    </message>
    <message>
        <source>Turning: %1 of %2 turns counted.</source>
        <translation>Dreht: %1 von %2 Umdrehungen gezählt.</translation>
    </message>
    <message>
        <source>Turning …</source>
        <translation>Dreht …</translation>
    </message>
    <message>
        <source>Which way did it go?</source>
        <translation>In welche Richtung ging es?</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Schreiben …</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Backup</name>
    <message>
        <source>The database could not be opened: a backup would be empty. Correct this first, then restart the panel.</source>
        <translation>Die Datenbank ließ sich nicht öffnen: eine Sicherung wäre leer. Zuerst beheben, dann das Panel neu starten.</translation>
    </message>
    <message>
        <source>CamPanel backup %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel Sicherung %1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>date, person</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 · recipes: %2 · users: %3 · CamPanel %4</source>
        <comment>when, how many, how many, version</comment>
        <translation>%1 · Rezepte: %2 · Benutzer: %3 · CamPanel %4</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>what is in it, place</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>cannot be used · %1</source>
        <comment>place</comment>
        <translation>nicht verwendbar · %1</translation>
    </message>
    <message>
        <source>The file is checked first. Nothing is changed before you confirm.</source>
        <translation>Zuerst wird die Datei geprüft. Vor Ihrer Bestätigung ändert sich nichts.</translation>
    </message>
    <message>
        <source>CamPanel before restore %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel vor Rückspielen %1</translation>
    </message>
    <message>
        <source>The restore was not started: %1. Nothing was changed.</source>
        <translation>Das Rückspielen wurde nicht begonnen: %1. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The file is valid: %1.
It replaces recipes, machine data, users with their PINs, alarms, audit trail and settings of this panel; bags and trends stay. The present state is saved as a backup on this panel, then the panel restarts.</source>
        <translation>Die Datei ist gültig: %1.
Sie ersetzt Rezepte, Maschinendaten, Benutzer mit PINs, Alarme, Protokoll und Einstellungen dieses Panels; Beutel und Trends bleiben. Der jetzige Stand wird auf dem Panel gesichert, dann startet es neu.</translation>
    </message>
    <message>
        <source>The file is valid: %1.
It replaces recipes, machine data, users with their PINs, alarms, audit trail, bags, trends and settings of this panel. The present state is saved as a backup on this panel, then the panel restarts.</source>
        <translation>Die Datei ist gültig: %1.
Sie ersetzt Rezepte, Maschinendaten, Benutzer mit PINs, Alarme, Protokoll, Beutel, Trends und Einstellungen dieses Panels. Der jetzige Stand wird auf dem Panel gesichert, dann startet es neu.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::BuilderFiles</name>
    <message>
        <source>recipes: %1</source>
        <translation>Rezepte: %1</translation>
    </message>
    <message>
        <source>Not taken from the card: %1. %2</source>
        <comment>file, whole sentence</comment>
        <translation>Nicht von der Karte übernommen: %1. %2</translation>
    </message>
    <message numerus="yes">
        <source>And %n more; the audit trail has all.</source>
        <translation>
            <numerusform>Und %n weitere; das Protokoll hat alle.</numerusform>
            <numerusform>Und %n weitere; das Protokoll hat alle.</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken from the card: %1.</source>
        <comment>list</comment>
        <translation>Von der Karte übernommen: %1.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CamFiles</name>
    <message>
        <source>A new file %1 will be written.</source>
        <translation>Eine neue Datei %1 wird geschrieben.</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <comment>number of knots or segments, date, place</comment>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>nicht verwendbar · %1 · %2</translation>
    </message>
    <message>
        <source>Line %1: %2 Correct the file; the panel reads it again automatically.</source>
        <comment>%2: whole sentence</comment>
        <translation>Zeile %1: %2 Korrigieren Sie die Datei; das Panel liest sie von selbst erneut.</translation>
    </message>
    <message>
        <source>%1 Correct the file; the panel reads it again automatically.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Korrigieren Sie die Datei; das Panel liest sie von selbst erneut.</translation>
    </message>
    <message>
        <source>%1, position %2 to %3, will replace those of the recipe. Undo restores them.</source>
        <comment>%1: number of knots or segments</comment>
        <translation>%1, Position %2 bis %3, ersetzen die des Rezepts. Rückgängig stellt sie wieder her.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CamSwitches</name>
    <message>
        <source>Cam switch %1: mode</source>
        <translation>Nocken %1: Betriebsart</translation>
    </message>
    <message>
        <source>Cam switch %1: on angle</source>
        <translation>Nocken %1: Einschaltwinkel</translation>
    </message>
    <message>
        <source>Cam switch %1: off angle</source>
        <translation>Nocken %1: Ausschaltwinkel</translation>
    </message>
    <message>
        <source>Cam switch %1: lead time</source>
        <translation>Nocken %1: Vorhaltezeit</translation>
    </message>
    <message>
        <source>Cam switch %1: on in every n-th cycle</source>
        <translation>Nocken %1: ein in jedem n-ten Zyklus</translation>
    </message>
    <message>
        <source>Drive enable</source>
        <translation>Antriebsfreigabe</translation>
    </message>
    <message>
        <source>%1: contact</source>
        <translation>%1: Kontakt</translation>
    </message>
    <message>
        <source>%1: filter time</source>
        <translation>%1: Filterzeit</translation>
    </message>
    <message>
        <source>Cam switch %1</source>
        <translation>Nocken %1</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Date coder pulse: film to the cut</source>
        <translation>Impuls für den Datumscodierer: Folie bis zum Schnitt</translation>
    </message>
    <message>
        <source>Date coder pulse: length</source>
        <translation>Impuls für den Datumscodierer: Dauer</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Commissioning</name>
    <message>
        <source>%1 commissioning %2</source>
        <comment>name of a file: recipe, date</comment>
        <translation>%1 Inbetriebnahme %2</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>The recipe has been edited since it was saved or downloaded.</source>
        <translation>Das Rezept wurde seit dem Speichern oder Laden bearbeitet.</translation>
    </message>
    <message>
        <source>Machine data</source>
        <translation>Maschinendaten</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Peaks</source>
        <translation>Höchstwerte</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>There is no table: the recipe cannot be downloaded.</source>
        <translation>Es gibt keine Tabelle: das Rezept kann nicht geladen werden.</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>Registerplan</translation>
    </message>
    <message>
        <source>Connected by</source>
        <translation>Verbunden über</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>simulierte Steuerung</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>Aktives Programm</translation>
    </message>
    <message>
        <source>Saved program</source>
        <translation>Gespeichertes Programm</translation>
    </message>
    <message>
        <source>The active program was not read back for this report.</source>
        <translation>Das aktive Programm wurde für diesen Bericht nicht zurückgelesen.</translation>
    </message>
    <message>
        <source>Last bags</source>
        <translation>Letzte Beutel</translation>
    </message>
    <message>
        <source>No bag has been measured yet.</source>
        <translation>Noch kein Beutel gemessen.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Mean length</source>
        <translation>Mittlere Länge</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Mittlere Abweichung</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>Within ±%1</source>
        <translation>Innerhalb ±%1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>Inbetriebnahmebericht</translation>
    </message>
    <message>
        <source>%1 · version %2</source>
        <comment>recipe</comment>
        <translation>%1 · Version %2</translation>
    </message>
    <message>
        <source>nobody logged in</source>
        <translation>niemand angemeldet</translation>
    </message>
    <message>
        <source>%1 · %2 · CamPanel %3</source>
        <comment>date, person, version</comment>
        <translation>%1 · %2 · CamPanel %3</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Curves of one cycle</source>
        <translation>Kurven eines Zyklus</translation>
    </message>
    <message>
        <source>Velocity, %1</source>
        <translation>Geschwindigkeit, %1</translation>
    </message>
    <message>
        <source>Acceleration, %1</source>
        <translation>Beschleunigung, %1</translation>
    </message>
    <message>
        <source>Pulse frequency, kHz</source>
        <translation>Pulsfrequenz, kHz</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Code of the recipe</source>
        <translation>Code des Rezepts</translation>
    </message>
    <message>
        <source>Code of the film reel</source>
        <translation>Code der Folienrolle</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <comment>recipe</comment>
        <translation>%1, nicht gespeichert</translation>
    </message>
    <message>
        <source>Machine with controller %1</source>
        <comment>serial number</comment>
        <translation>Maschine mit Steuerung %1</translation>
    </message>
    <message>
        <source>Machine with an unknown controller</source>
        <translation>Maschine mit unbekannter Steuerung</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Name and signature</source>
        <translation>Name und Unterschrift</translation>
    </message>
    <message>
        <source>The controller follows its clock.</source>
        <translation>Die Steuerung folgt ihrem Takt.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Controller</name>
    <message>
        <source>Unknown state</source>
        <translation>Unbekannter Zustand</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Sucht</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Verbindet</translation>
    </message>
    <message>
        <source>No connection</source>
        <translation>Keine Verbindung</translation>
    </message>
    <message>
        <source>Wrong device</source>
        <translation>Falsches Gerät</translation>
    </message>
    <message>
        <source>Port problem</source>
        <translation>Schnittstellenproblem</translation>
    </message>
    <message>
        <source>Connection restored. The controller has restarted meanwhile.</source>
        <translation>Verbindung wieder da. Die Steuerung hat inzwischen neu gestartet.</translation>
    </message>
    <message>
        <source>Connection restored. The controller has a different program now.</source>
        <translation>Verbindung wieder da. Die Steuerung hat jetzt ein anderes Programm.</translation>
    </message>
    <message>
        <source>Connection restored. Before: %1. Now: %2.</source>
        <comment>states of the machine</comment>
        <translation>Verbindung wieder da. Vorher: %1. Jetzt: %2.</translation>
    </message>
    <message>
        <source>Connection restored: Stop was sent, and the controller accepted the command.</source>
        <translation>Verbindung wieder da: Stopp wurde gesendet und von der Steuerung angenommen.</translation>
    </message>
    <message>
        <source>Stop was withdrawn and will not be sent.</source>
        <translation>Stopp wurde zurückgezogen und wird nicht gesendet.</translation>
    </message>
    <message>
        <source>Stop was not sent: a different machine is connected now.</source>
        <translation>Stopp wurde nicht gesendet: jetzt ist eine andere Maschine verbunden.</translation>
    </message>
    <message>
        <source>Connection restored: Stop was sent, but the machine was no longer running.</source>
        <translation>Verbindung wieder da: Stopp wurde gesendet, aber die Maschine lief nicht mehr.</translation>
    </message>
    <message>
        <source>Stop was sent. Waiting for the response.</source>
        <translation>Stopp wurde gesendet. Antwort wird erwartet.</translation>
    </message>
    <message>
        <source>Stop is not sent yet. The panel sends Stop as soon as the connection is restored.</source>
        <translation>Stopp ist noch nicht gesendet. Das Panel sendet Stopp, sobald die Verbindung wieder da ist.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::CutterMap</name>
    <message>
        <source>Lmin: the jaws just fill the window</source>
        <translation>Lmin: die Backen füllen das Fenster gerade</translation>
    </message>
    <message>
        <source>h/c: the knife turns evenly</source>
        <translation>h/c: das Messer dreht gleichmäßig</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>%1: bag length, %2: rate</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Up to %1; limited by: %2.</source>
        <comment>%1: rate, %2: name of the limit</comment>
        <translation>Bis %1; begrenzt durch: %2.</translation>
    </message>
    <message>
        <source>No rate is possible; limited by: %1.</source>
        <comment>name of the limit</comment>
        <translation>Keine Taktzahl ist möglich; begrenzt durch: %1.</translation>
    </message>
    <message>
        <source>Lcrit: the longest ramps stop the knife</source>
        <translation>Lcrit: die längsten Rampen halten das Messer an</translation>
    </message>
    <message>
        <source>Line up to %1; limited by: %2. This program: %3; the run ends above %4.</source>
        <comment>%1, %3, %4: speeds, %2: name of the limit</comment>
        <translation>Linie bis %1; begrenzt durch: %2. Dieses Programm: %3; über %4 endet der Lauf.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::DatabaseService</name>
    <message>
        <source>%1 Until then, new data are lost at a restart.</source>
        <comment>%1: whole sentences</comment>
        <translation>%1 Bis dahin gehen neue Daten beim Neustart verloren.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged. The last good copy is used; the damaged file is kept as %1.</source>
        <translation>Die Datenbank war beschädigt. Die letzte gute Kopie wird verwendet; die beschädigte Datei liegt unter %1.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was damaged and there was no copy. A new, empty database was created; the damaged file is kept as %1.</source>
        <translation>Die Datenbank war beschädigt, und es gab keine Kopie. Eine neue, leere wurde angelegt; die beschädigte Datei liegt unter %1.</translation>
    </message>
    <message>
        <source>The backup has been restored. The previous data are kept in %1.</source>
        <translation>Die Sicherung ist zurückgespielt. Die vorigen Daten liegen unter %1.</translation>
    </message>
    <message>
        <source>The restore could not be completed: %1. The panel tries again at the next start.</source>
        <translation>Das Rückspielen gelang nicht ganz: %1. Das Panel versucht es beim nächsten Start erneut.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was missing or empty and was replaced by the last good copy. Data saved after the last start are lost.</source>
        <translation>Die Datenbank fehlte oder war leer und wurde durch die letzte gute Kopie ersetzt. Nach dem letzten Start gespeicherte Daten sind verloren.</translation>
    </message>
    <message>
        <source>The panel&apos;s database was missing or empty, and there was no good copy. A new, empty database was created; restore a backup.</source>
        <translation>Die Datenbank fehlte oder war leer, und es gab keine gute Kopie. Eine neue, leere wurde angelegt; eine Sicherung zurückspielen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::DryRun</name>
    <message>
        <source>Time in the cycle</source>
        <translation>Zeit im Zyklus</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Pulse frequency</source>
        <translation>Pulsfrequenz</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Knife speed</source>
        <translation>Messergeschwindigkeit</translation>
    </message>
    <message>
        <source>Film speed</source>
        <translation>Foliengeschwindigkeit</translation>
    </message>
    <message>
        <source>Knife speed / film speed</source>
        <translation>Messer-/Foliengeschwindigkeit</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Sync window</source>
        <translation>Synchronbereich</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Editor</name>
    <message>
        <source>Displacement law</source>
        <translation>Bewegungsgesetz</translation>
    </message>
    <message>
        <source>Speed law</source>
        <translation>Bewegungsgesetz</translation>
    </message>
    <message>
        <source>The unsaved edits were lost: their file is damaged. The saved recipe is open.</source>
        <translation>Die ungespeicherten Änderungen sind verloren: ihre Datei ist beschädigt. Das gespeicherte Rezept ist offen.</translation>
    </message>
    <message>
        <source>Restored the stored recipe %1. Undo brings the edits back.</source>
        <translation>Das gespeicherte Rezept %1 ist wiederhergestellt. Rückgängig bringt die Änderungen zurück.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Explanations</name>
    <message>
        <source>Rate</source>
        <translation>Taktzahl</translation>
    </message>
    <message>
        <source>bags/min</source>
        <translation>Beutel/min</translation>
    </message>
    <message>
        <source>Bags per minute at the present master speed. This value is calculated, not counted.</source>
        <translation>Beutel je Minute bei der jetzigen Leitgeschwindigkeit. Dieser Wert ist berechnet, nicht gezählt.</translation>
    </message>
    <message>
        <source>rate of the program × master speed</source>
        <translation>Taktzahl des Programms × Leitgeschwindigkeit</translation>
    </message>
    <message>
        <source>Mean bag length</source>
        <translation>Mittlere Beutellänge</translation>
    </message>
    <message>
        <source>Mean of the last bags (%1, at most 60) since the last change of the set length.</source>
        <translation>Mittel der letzten Beutel (%1, höchstens 60) seit der letzten Änderung der Solllänge.</translation>
    </message>
    <message>
        <source>set length + sum of their deviations / bags</source>
        <translation>Solllänge + Summe der Abweichungen / Beutel</translation>
    </message>
    <message>
        <source>Standard deviation of the bag length</source>
        <translation>Standardabweichung der Beutellänge</translation>
    </message>
    <message>
        <source>About two thirds of the last bags (%1) are closer to the mean than this value.</source>
        <translation>Etwa zwei Drittel der letzten Beutel (%1) liegen näher am Mittel als dieser Wert.</translation>
    </message>
    <message>
        <source>√(sum of (deviation − mean deviation)² / (bags − 1))</source>
        <translation>√(Summe von (Abweichung − mittlere Abweichung)² / (Beutel − 1))</translation>
    </message>
    <message>
        <source>Bags within the tolerance</source>
        <translation>Beutel innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Number of the last bags (%1) within ±%2. Set the tolerance in Settings, Machine.</source>
        <translation>Anzahl der letzten Beutel (%1) innerhalb ±%2. Toleranz unter Einstellungen, Maschine einstellen.</translation>
    </message>
    <message>
        <source>Start-up scrap, bags of a change of program and those at jaws that stood or jammed are left out: %1.</source>
        <translation>Anlaufausschuss, Beutel eines Programmwechsels und die an stehenden oder verklemmten Backen zählen nicht: %1.</translation>
    </message>
    <message>
        <source>bags with a deviation within the tolerance</source>
        <translation>Beutel mit Abweichung innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Deviation of the last bag</source>
        <translation>Abweichung des letzten Beutels</translation>
    </message>
    <message>
        <source>Positive: the bag is too long. With skipped cuts, the set length is the sum of all lengths in the bag.</source>
        <translation>Positiv: der Beutel ist zu lang. Bei ausgelassenen Schnitten ist die Solllänge die Summe aller Längen im Beutel.</translation>
    </message>
    <message>
        <source>measured length − set length</source>
        <translation>gemessene Länge − Solllänge</translation>
    </message>
    <message>
        <source>Mark error</source>
        <translation>Markenfehler</translation>
    </message>
    <message>
        <source>Mark error of the last cut with a mark, measured by the controller. Mark tracking corrects a part of this error with each cut.</source>
        <translation>Markenfehler des letzten Schnitts mit Marke, von der Steuerung gemessen. Die Markenregelung korrigiert mit jedem Schnitt einen Teil.</translation>
    </message>
    <message>
        <source>position of the cut − position required by its mark</source>
        <translation>Position des Schnitts − von der Marke verlangte Position</translation>
    </message>
    <message>
        <source>Film saved</source>
        <translation>Gesparte Folie</translation>
    </message>
    <message>
        <source>Film that was not used because the film waited for missing products. Counted since power-on of the controller.</source>
        <translation>Folie, die nicht verbraucht wurde, weil sie auf fehlende Produkte wartete. Seit dem Einschalten der Steuerung gezählt.</translation>
    </message>
    <message>
        <source>missing products × bag length at that time</source>
        <translation>fehlende Produkte × Beutellänge zu dieser Zeit</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>Schleppfehler</translation>
    </message>
    <message>
        <source>Last reported difference between commanded and actual position of the axis.</source>
        <translation>Zuletzt gemeldete Differenz zwischen Soll- und Istposition der Achse.</translation>
    </message>
    <message>
        <source>error in pulses / pulses per mm</source>
        <translation>Fehler in Pulsen / Pulse je mm</translation>
    </message>
    <message>
        <source>Good strokes</source>
        <translation>Gute Hübe</translation>
    </message>
    <message>
        <source>Number of the last strokes (%1) that ended at the press position with a force of %2 to %3 N.</source>
        <translation>Anzahl der letzten Hübe (%1), die an der Pressposition mit einer Kraft von %2 bis %3 N endeten.</translation>
    </message>
    <message>
        <source>strokes that the controller evaluated as good</source>
        <translation>Hübe, die die Steuerung als gut bewertet hat</translation>
    </message>
    <message>
        <source>Maximum possible rate</source>
        <translation>Höchste mögliche Taktzahl</translation>
    </message>
    <message>
        <source>Maximum rate with this bag length, law and machine; limited by: %1. Speeds rise with the rate, acceleration with its square.</source>
        <translation>Höchste Taktzahl mit dieser Beutellänge, diesem Gesetz und dieser Maschine; begrenzt durch: %1. Geschwindigkeiten wachsen mit der Taktzahl, die Beschleunigung mit ihrem Quadrat.</translation>
    </message>
    <message>
        <source>rate × allowed / peak, rounded down</source>
        <translation>Taktzahl × erlaubt / Höchstwert, abgerundet</translation>
    </message>
    <message>
        <source>rate × √(allowed / peak), rounded down</source>
        <translation>Taktzahl × √(erlaubt / Höchstwert), abgerundet</translation>
    </message>
    <message>
        <source>the limit itself</source>
        <translation>die Grenze selbst</translation>
    </message>
    <message>
        <source>Peak motor speed</source>
        <translation>Höchste Motordrehzahl</translation>
    </message>
    <message>
        <source>Motor speed at the maximum knife speed.</source>
        <translation>Motordrehzahl bei der höchsten Messergeschwindigkeit.</translation>
    </message>
    <message>
        <source>Peak knife acceleration</source>
        <translation>Höchste Messerbeschleunigung</translation>
    </message>
    <message>
        <source>Acceleration at the fastest change of the knife speed.</source>
        <translation>Beschleunigung bei der schnellsten Änderung der Messergeschwindigkeit.</translation>
    </message>
    <message>
        <source>Peak pulse frequency</source>
        <translation>Höchste Pulsfrequenz</translation>
    </message>
    <message>
        <source>Output frequency of the controller at the maximum knife speed.</source>
        <translation>Ausgangsfrequenz der Steuerung bei der höchsten Messergeschwindigkeit.</translation>
    </message>
    <message>
        <source>Line utilization</source>
        <translation>Auslastung der Leitung</translation>
    </message>
    <message>
        <source>Time of the frames on the wire at this baud rate, with the silent intervals of the standard, divided by the communication time. At 100 % no master could poll faster; the rest is time spent waiting for controller and adapter.</source>
        <translation>Zeit der Telegramme auf der Leitung bei dieser Baudrate, mit den Pausen der Norm, geteilt durch die Kommunikationszeit. Bei 100 % könnte kein Master schneller fragen; der Rest ist Warten auf Steuerung und Adapter.</translation>
    </message>
    <message>
        <source>time of the frames on the wire / communication time</source>
        <translation>Zeit der Telegramme auf der Leitung / Kommunikationszeit</translation>
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
        <translation>Höchste Antwortzeit</translation>
    </message>
    <message>
        <source>Time from sending the request to the last byte of the response. This is one single response, perhaps hours ago: the percentages describe normal operation better.</source>
        <translation>Zeit vom Senden der Anfrage bis zum letzten Byte der Antwort. Eine einzige Antwort, vielleicht Stunden alt: die Prozentwerte beschreiben den Normalbetrieb besser.</translation>
    </message>
    <message>
        <source>maximum since the last reset of the counters</source>
        <translation>Höchstwert seit dem letzten Zurücksetzen der Zähler</translation>
    </message>
    <message>
        <source>50 % of responses within</source>
        <translation>50 % der Antworten in</translation>
    </message>
    <message>
        <source>%1 % of responses within</source>
        <translation>%1 % der Antworten in</translation>
    </message>
    <message>
        <source>Time from sending the request to the last byte of the response, both frames on the wire included. Counted since the start of the panel or the last reset of the counters.</source>
        <translation>Zeit vom Senden der Anfrage bis zum letzten Byte der Antwort, mit beiden Telegrammen auf der Leitung. Gezählt seit dem Start des Panels oder dem letzten Zurücksetzen.</translation>
    </message>
    <message>
        <source>all responses sorted by time: value at %1 % of their number, up to 6.25 % too high, never too low</source>
        <translation>alle Antworten nach Zeit sortiert: Wert bei %1 % ihrer Anzahl, bis 6,25 % zu hoch, nie zu niedrig</translation>
    </message>
    <message>
        <source>time of response %1 of %2</source>
        <translation>Zeit der Antwort %1 von %2</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>Antwort blieb aus</translation>
    </message>
    <message>
        <source>Waiting time for a response, in addition to both frames on the wire. The panel adapts this time to controller and adapter, and doubles it without a response.</source>
        <translation>Wartezeit auf eine Antwort, zusätzlich zu beiden Telegrammen auf der Leitung. Das Panel passt sie an Steuerung und Adapter an und verdoppelt sie ohne Antwort.</translation>
    </message>
    <message>
        <source>%1 × the time in which 99 % of the last responses started, from %2 to %3 ms</source>
        <translation>%1 × die Zeit, in der 99 % der letzten Antworten begannen, von %2 bis %3 ms</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean of all values recorded in the displayed time (n = %1).</source>
        <translation>Mittel aller im gezeigten Zeitraum aufgezeichneten Werte (n = %1).</translation>
    </message>
    <message>
        <source>sum of the values / n</source>
        <translation>Summe der Werte / n</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>About two thirds of the values are closer to the mean than this value.</source>
        <translation>Etwa zwei Drittel der Werte liegen näher am Mittel als dieser Wert.</translation>
    </message>
    <message>
        <source>√(sum of (value − mean)² / (n − 1))</source>
        <translation>√(Summe von (Wert − Mittel)² / (n − 1))</translation>
    </message>
    <message>
        <source>Minimum and maximum</source>
        <translation>Minimum und Maximum</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>lowest, highest</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Minimum and maximum are single values. The curve shows the mean of each column, the pale band its minimum and maximum.</source>
        <translation>Minimum und Maximum sind Einzelwerte. Die Kurve zeigt das Mittel jeder Spalte, das blasse Band Minimum und Maximum.</translation>
    </message>
    <message>
        <source>minimum … maximum of the n values</source>
        <translation>Minimum … Maximum der n Werte</translation>
    </message>
    <message>
        <source>Within the tolerance</source>
        <translation>Innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Each bag is compared with the tolerance that was valid at its production.</source>
        <translation>Jeder Beutel wird mit der Toleranz verglichen, die bei seiner Herstellung galt.</translation>
    </message>
    <message>
        <source>bags with a deviation within the tolerance / n</source>
        <translation>Beutel mit Abweichung innerhalb der Toleranz / n</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Mean at the cursor</source>
        <translation>Mittel am Cursor</translation>
    </message>
    <message>
        <source>One column of the curves covers %1. At the cursor the minimum was %2, the maximum %3.</source>
        <translation>Eine Spalte der Kurven umfasst %1. Am Cursor war das Minimum %2, das Maximum %3.</translation>
    </message>
    <message>
        <source>sum of the column&apos;s values / number of values</source>
        <translation>Summe der Werte der Spalte / Anzahl der Werte</translation>
    </message>
    <message>
        <source>%1 of 100 responses took at most this time.</source>
        <translation>%1 von 100 Antworten dauerten höchstens so lange.</translation>
    </message>
    <message>
        <source>rate × seal time / required seal time, rounded down</source>
        <translation>Taktzahl × Siegelzeit / nötige Siegelzeit, abgerundet</translation>
    </message>
    <message>
        <source>Sync window</source>
        <translation>Synchronbereich</translation>
    </message>
    <message>
        <source>Angle over which the knife moves at film speed. It must exceed the contact angle of the jaws by 2°.</source>
        <translation>Winkel, über den das Messer mit Foliengeschwindigkeit läuft. Er muss den Kontaktwinkel der Backen um 2° überschreiten.</translation>
    </message>
    <message>
        <source>Seal time</source>
        <translation>Siegelzeit</translation>
    </message>
    <message>
        <source>Time of the jaws on the film at this rate.</source>
        <translation>Zeit der Backen auf der Folie bei dieser Taktzahl.</translation>
    </message>
    <message>
        <source>Time of the jaws on the film at the present rate. The contact angle is that of the recipe on the Motion page.</source>
        <translation>Zeit der Backen auf der Folie bei der jetzigen Taktzahl. Der Kontaktwinkel ist der des Rezepts auf der Seite Bewegung.</translation>
    </message>
    <message>
        <source>60 000 × arc of the jaws / (sync ratio × bag length × rate)</source>
        <translation>60 000 × Bogen der Backen / (Synchronverhältnis × Beutellänge × Taktzahl)</translation>
    </message>
    <message>
        <source>RMS knife acceleration</source>
        <translation>Effektive Messerbeschleunigung</translation>
    </message>
    <message>
        <source>Root mean square of the acceleration over a cycle. It heats the motor; I2 is the integral of the squared slope of the law.</source>
        <translation>Effektivwert der Beschleunigung über einen Zyklus. Er erwärmt den Motor; I2 ist das Integral der quadrierten Steigung des Gesetzes.</translation>
    </message>
    <message>
        <source>Speed ratio k0</source>
        <translation>Geschwindigkeitsverhältnis k0</translation>
    </message>
    <message>
        <source>Film speed divided by base speed, equation (9) of the paper. It follows from the recipe.</source>
        <translation>Foliengeschwindigkeit durch Grundgeschwindigkeit, Gleichung (9) des Aufsatzes. Es folgt aus dem Rezept.</translation>
    </message>
    <message>
        <source>Speed of the base circle ω</source>
        <translation>Drehzahl des Grundkreises ω</translation>
    </message>
    <message>
        <source>Angular speed of the knife at base speed, equation (7) of the paper. Its base circle has the knife radius.</source>
        <translation>Winkelgeschwindigkeit des Messers bei Grundgeschwindigkeit, Gleichung (7) des Aufsatzes. Sein Grundkreis hat den Messerradius.</translation>
    </message>
    <message>
        <source>Coefficients C0 to C%1</source>
        <translation>Koeffizienten C0 bis C%1</translation>
    </message>
    <message>
        <source>The law is the polynomial s = C0 + C1 t + C2 t^2 … of the paper, s in mm and t in ms: %1.</source>
        <translation>Das Gesetz ist das Polynom s = C0 + C1 t + C2 t^2 … des Aufsatzes, s in mm und t in ms: %1.</translation>
    </message>
    <message>
        <source>rate × √((allowed − friction) / (peak − friction)), rounded down</source>
        <translation>Taktzahl × √((erlaubt − Reibung) / (Höchstwert − Reibung)), abgerundet</translation>
    </message>
    <message>
        <source>rate × √((allowed + friction) / (peak + friction)), rounded down</source>
        <translation>Taktzahl × √((erlaubt + Reibung) / (Höchstwert + Reibung)), abgerundet</translation>
    </message>
    <message>
        <source>rate × ((allowed² − friction²) / (RMS² − friction²))^(1/4), rounded down</source>
        <translation>Taktzahl × ((erlaubt² − Reibung²) / (Effektiv² − Reibung²))^(1/4), abgerundet</translation>
    </message>
    <message>
        <source>Peak motor torque</source>
        <translation>Höchstes Motormoment</translation>
    </message>
    <message>
        <source>Maximum torque at the motor. Friction adds to it while the knife speeds up, and helps while the knife slows down.</source>
        <translation>Höchstes Moment am Motor. Reibung kommt hinzu, während das Messer beschleunigt, und hilft, während es bremst.</translation>
    </message>
    <message>
        <source>RMS motor torque</source>
        <translation>Effektives Motormoment</translation>
    </message>
    <message>
        <source>Root mean square over one cycle. It heats the motor, so it stays below the rated torque.</source>
        <translation>Effektivwert über einen Zyklus. Er erwärmt den Motor und bleibt deshalb unter dem Nennmoment.</translation>
    </message>
    <message>
        <source>Vibration over the cycle</source>
        <translation>Schwingung im Zyklus</translation>
    </message>
    <message>
        <source>Vibration after the move</source>
        <translation>Schwingung nach der Bewegung</translation>
    </message>
    <message>
        <source>Error of the load behind the shaft, peak to peak over one cycle.</source>
        <translation>Fehler der Last hinter der Welle, Spitze zu Spitze über einen Zyklus.</translation>
    </message>
    <message>
        <source>Amplitude of the load behind the shaft after the end of the move.</source>
        <translation>Amplitude der Last hinter der Welle nach dem Ende der Bewegung.</translation>
    </message>
    <message>
        <source>f0 = %1 Hz, ζ = %2, T = %3 s</source>
        <translation>f0 = %1 Hz, ζ = %2, T = %3 s</translation>
    </message>
    <message>
        <source>f0 = %1 Hz, T = %2 s</source>
        <translation>f0 = %1 Hz, T = %2 s</translation>
    </message>
    <message>
        <source>Error while sealing</source>
        <translation>Fehler beim Siegeln</translation>
    </message>
    <message>
        <source>Vibration of the knife shaft, peak to peak, between both ends of the sealing window.</source>
        <translation>Schwingung der Messerwelle, Spitze zu Spitze, zwischen beiden Enden des Siegelbereichs.</translation>
    </message>
    <message>
        <source>Torque, largest difference</source>
        <translation>Moment, größte Differenz</translation>
    </message>
    <message>
        <source>torque that the drive reports − (J α + friction), of the rated torque</source>
        <translation>vom Antrieb gemeldetes Moment − (J α + Reibung), bezogen auf das Nennmoment</translation>
    </message>
    <message>
        <source>Compared while the machine runs at full speed.</source>
        <translation>Wird verglichen, während die Maschine mit voller Geschwindigkeit läuft.</translation>
    </message>
    <message>
        <source>Largest of the last readings at full speed (%1), at %2° of the cycle. The drive lags behind the program, so the difference is largest where the acceleration changes fast.</source>
        <translation>Größter der letzten Werte bei voller Geschwindigkeit (%1), bei %2° des Zyklus. Der Antrieb läuft nach; die Differenz ist dort am größten, wo sich die Beschleunigung schnell ändert.</translation>
    </message>
    <message>
        <source>Availability</source>
        <translation>Verfügbarkeit</translation>
    </message>
    <message>
        <source>Share of the planned time in which the machine ran. Planned time is the recorded time of the shift (%1 min) without planned stops (%2 min).</source>
        <translation>Anteil der geplanten Zeit, in der die Maschine lief. Geplante Zeit ist die aufgezeichnete Zeit der Schicht (%1 min) ohne geplante Stillstände (%2 min).</translation>
    </message>
    <message>
        <source>run time / planned time</source>
        <translation>Laufzeit / geplante Zeit</translation>
    </message>
    <message>
        <source>%1 min / %2 min</source>
        <translation>%1 min / %2 min</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Speed compared with the ideal rate: the fastest rate of each recipe, or the rate in Settings. A piece is a bag, a stroke or a cycle; a skipped cut takes the time of a piece. Waiting of up to %1 s is a loss of performance. At most 100 %.</source>
        <translation>Geschwindigkeit im Vergleich zur idealen Taktrate: die schnellste Taktrate jedes Rezepts oder die in den Einstellungen. Ein Stück ist ein Beutel, ein Hub oder ein Zyklus; ein ausgelassener Schnitt braucht die Zeit eines Stücks. Warten bis %1 s ist ein Leistungsverlust. Höchstens 100 %.</translation>
    </message>
    <message>
        <source>sum of pieces × ideal time per piece / run time</source>
        <translation>Summe der Stücke × ideale Zeit je Stück / Laufzeit</translation>
    </message>
    <message>
        <source>%1 min for %2 pieces / %3 min</source>
        <translation>%1 min für %2 Stück / %3 min</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Share of good pieces. Not good: %1 out of tolerance, %2 start-up scrap, %3 skipped cuts.</source>
        <translation>Anteil der guten Stücke. Nicht gut: %1 außer Toleranz, %2 Anfahrausschuss, %3 ausgelassene Schnitte.</translation>
    </message>
    <message>
        <source>good pieces / pieces</source>
        <translation>gute Stücke / Stücke</translation>
    </message>
    <message>
        <source>Overall equipment effectiveness (OEE)</source>
        <translation>Gesamtanlageneffektivität (OEE)</translation>
    </message>
    <message>
        <source>Good pieces at the ideal rate, as a share of the planned time.</source>
        <translation>Gute Stücke bei idealer Taktrate, als Anteil der geplanten Zeit.</translation>
    </message>
    <message>
        <source>availability × performance × quality</source>
        <translation>Verfügbarkeit × Leistung × Qualität</translation>
    </message>
    <message>
        <source>Distance from the expected mark</source>
        <translation>Abstand von der erwarteten Marke</translation>
    </message>
    <message>
        <source>The distance of the newest edge of the mark sensor from the place where the controller expected the mark. An edge inside the window is taken as the mark, any other is not.</source>
        <translation>Der Abstand der neuesten Flanke des Markensensors von der Stelle, an der die Steuerung die Marke erwartet hat. Eine Flanke im Fenster gilt als die Marke, jede andere nicht.</translation>
    </message>
    <message>
        <source>place of the edge − place of the expected mark</source>
        <translation>Ort der Flanke − Ort der erwarteten Marke</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FileExchange</name>
    <message>
        <source>%1 is read-only. Unlock the stick or choose another location.</source>
        <translation>%1 ist schreibgeschützt. Stick entsperren oder einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · schreibgeschützt</translation>
    </message>
    <message>
        <source>Written: %1. You can remove the stick now.</source>
        <translation>Geschrieben: %1. Der Stick kann jetzt abgezogen werden.</translation>
    </message>
    <message>
        <source>%1 Also missing: %2.</source>
        <comment>%1: whole sentences, %2: files</comment>
        <translation>%1 Außerdem fehlen: %2.</translation>
    </message>
    <message>
        <source>Written: %1 of %2 files. %3</source>
        <comment>%3: whole sentences</comment>
        <translation>Geschrieben: %1 von %2 Dateien. %3</translation>
    </message>
    <message>
        <source>%1 files in %2</source>
        <comment>number, folder</comment>
        <translation>%1 Dateien in %2</translation>
    </message>
    <message>
        <source>Some files are not shown</source>
        <translation>Einige Dateien fehlen hier</translation>
    </message>
    <message>
        <source>%1 · no answer</source>
        <translation>%1 · keine Antwort</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FilmCheck</name>
    <message>
        <source>Wrong film reel: %1 was scanned, the recipe needs %2. Load and scan the right reel.</source>
        <translation>Falsche Folienrolle: %1 wurde gescannt, das Rezept braucht %2. Richtige Rolle einlegen und scannen.</translation>
    </message>
    <message>
        <source>Unknown code %1: no recipe and no film reel has it. Load and scan the film reel %2.</source>
        <translation>Unbekannter Code %1: kein Rezept und keine Folienrolle hat ihn. Folienrolle %2 einlegen und scannen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::FrameList</name>
    <message>
        <source>Sent at %1</source>
        <translation>Gesendet um %1</translation>
    </message>
    <message>
        <source>Received at %1</source>
        <translation>Empfangen um %1</translation>
    </message>
    <message>
        <source>link frames</source>
        <translation>Telegramme</translation>
    </message>
</context>
<context>
    <name>campanel::panel::HandSpeed</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
</context>
<context>
    <name>campanel::panel::HandTrims</name>
    <message>
        <source>The line before this machine places the products.</source>
        <translation>Die Linie vor dieser Maschine legt die Produkte.</translation>
    </message>
    <message>
        <source>The marks set the length.</source>
        <translation>Die Marken bestimmen die Länge.</translation>
    </message>
    <message>
        <source>Limit reached: ±%1.</source>
        <translation>Grenze erreicht: ±%1.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Homing</name>
    <message>
        <source>Referenced</source>
        <translation>Referenziert</translation>
    </message>
    <message>
        <source>Top position known</source>
        <translation>Oberste Lage bekannt</translation>
    </message>
    <message>
        <source>Not referenced</source>
        <translation>Nicht referenziert</translation>
    </message>
    <message>
        <source>Top position not known</source>
        <translation>Oberste Lage unbekannt</translation>
    </message>
    <message>
        <source>No reference run required</source>
        <translation>Keine Referenzfahrt nötig</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Keep hands away: the knife turns slowly forward to the index mark of its shaft, brakes and returns to 0°. Start begins with the reference run when required.</source>
        <translation>Hände weg: das Messer dreht langsam vorwärts zur Nullmarke seiner Welle, bremst und kehrt auf 0° zurück. Start referenziert bei Bedarf selbsttätig.</translation>
    </message>
    <message>
        <source>The axis turns slowly forward to the index mark of its motor, brakes and returns to position 0. Start begins with the reference run when required.</source>
        <translation>Die Achse dreht langsam vorwärts zur Nullmarke ihres Motors, bremst und kehrt auf Position 0 zurück. Start referenziert bei Bedarf selbsttätig.</translation>
    </message>
    <message>
        <source>Moves start at the present axis position, so no reference run is required. The reference run turns slowly to the motor&apos;s index mark, which becomes position 0.</source>
        <translation>Bewegungen beginnen an der jetzigen Position; eine Referenzfahrt ist nicht nötig. Sie dreht langsam zur Nullmarke des Motors, die Position 0 wird.</translation>
    </message>
    <message>
        <source>No motion: the present ram position becomes the top position, the reference of all depths. Jog the ram there first; a wrong top position makes every stroke wrong.</source>
        <translation>Ohne Bewegung: die jetzige Stößellage wird oberste Lage, Bezug aller Tiefen. Stößel zuerst dorthin tippen; eine falsche oberste Lage macht jeden Hub falsch.</translation>
    </message>
    <message>
        <source>The reference run depends on the program. Download a recipe first.</source>
        <translation>Die Referenzfahrt hängt vom Programm ab. Zuerst ein Rezept laden.</translation>
    </message>
    <message>
        <source>Reference run</source>
        <translation>Referenz­fahrt</translation>
    </message>
    <message>
        <source>Set as top position</source>
        <translation>Oberste Lage setzen</translation>
    </message>
    <message>
        <source>Searching for the index mark …</source>
        <translation>Die Nullmarke wird gesucht …</translation>
    </message>
    <message>
        <source>The last reference run found the index mark.</source>
        <translation>Die letzte Referenzfahrt hat die Nullmarke gefunden.</translation>
    </message>
    <message>
        <source>The ram position was set as top position.</source>
        <translation>Die Stößellage wurde als oberste Lage gesetzt.</translation>
    </message>
    <message>
        <source>The last reference run was stopped before its end.</source>
        <translation>Die letzte Referenzfahrt wurde vor ihrem Ende gestoppt.</translation>
    </message>
    <message>
        <source>The last reference run failed: no index mark within two revolutions, or the axis did not follow. See the alarm.</source>
        <translation>Die letzte Referenzfahrt schlug fehl: keine Nullmarke in zwei Umdrehungen, oder die Achse folgte nicht. Siehe Alarm.</translation>
    </message>
    <message>
        <source>The connection was lost during the reference run: the result is unknown.</source>
        <translation>Die Verbindung ging während der Referenzfahrt verloren: Ergebnis unbekannt.</translation>
    </message>
    <message>
        <source>Keep hands away: the axis turns slowly to 0°, the shorter way. Its encoder keeps the position without power, so no index mark is searched. Start begins with the reference run when required.</source>
        <translation>Hände weg: die Achse dreht langsam auf dem kürzeren Weg auf 0°. Ihr Geber behält die Position ohne Strom, daher wird keine Nullmarke gesucht. Start referenziert bei Bedarf selbsttätig.</translation>
    </message>
    <message>
        <source>Turning to 0° …</source>
        <translation>Dreht auf 0° …</translation>
    </message>
    <message>
        <source>The last reference run ended at 0°.</source>
        <translation>Die letzte Referenzfahrt endete bei 0°.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::IoList</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 Pulse</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Encoder of the axis</source>
        <translation>Geber der Achse</translation>
    </message>
    <message>
        <source>Encoder, speed</source>
        <translation>Geber, Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>not found yet</source>
        <translation>noch nicht gefunden</translation>
    </message>
    <message>
        <source>found or not required</source>
        <translation>gefunden oder nicht nötig</translation>
    </message>
    <message>
        <source>Heartbeat of the panel</source>
        <translation>Lebenszeichen des Panels</translation>
    </message>
    <message>
        <source>no. %1</source>
        <comment>of a heartbeat</comment>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>Pulses to the axis</source>
        <translation>Pulse zur Achse</translation>
    </message>
    <message>
        <source>Pulses sent</source>
        <translation>Gesendete Pulse</translation>
    </message>
    <message>
        <source>Sent minus encoder</source>
        <translation>Gesendet minus Geber</translation>
    </message>
    <message>
        <source>%1 marks</source>
        <translation>%1 Marken</translation>
    </message>
    <message>
        <source>%1 products placed</source>
        <translation>%1 Produkte gelegt</translation>
    </message>
    <message>
        <source>Encoder of the film</source>
        <translation>Geber der Folie</translation>
    </message>
    <message>
        <source>Pulses to the film</source>
        <translation>Pulse zur Folie</translation>
    </message>
    <message>
        <source>Knife synchronous with film</source>
        <translation>Messer synchron zur Folie</translation>
    </message>
    <message>
        <source>Film, sent minus encoder</source>
        <translation>Folie, gesendet minus Geber</translation>
    </message>
    <message>
        <source>Torque of the axis, of rated</source>
        <translation>Moment der Achse, vom Nennmoment</translation>
    </message>
    <message>
        <source>Encoder of the infeed</source>
        <translation>Geber der Zuführung</translation>
    </message>
    <message>
        <source>Infeed, sent minus encoder</source>
        <translation>Zuführung, gesendet minus Geber</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>percent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>axis</source>
        <comment>kept position</comment>
        <translation>Achse</translation>
    </message>
    <message>
        <source>film</source>
        <comment>kept position</comment>
        <translation>Folie</translation>
    </message>
    <message>
        <source>infeed</source>
        <comment>kept position</comment>
        <translation>Zuführung</translation>
    </message>
    <message>
        <source>Positions kept without power</source>
        <translation>Ohne Strom behaltene Positionen</translation>
    </message>
    <message>
        <source>none</source>
        <comment>kept positions</comment>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>campanel::panel::JamWatch</name>
    <message>
        <source>The controller reports a state that this panel does not know. Update the panel.</source>
        <translation>Die Steuerung meldet einen Zustand, den dieses Panel nicht kennt. Panel aktualisieren.</translation>
    </message>
    <message>
        <source>Off. Switch jam detection on in the list of this page.</source>
        <translation>Aus. Die Klemmerkennung in der Liste dieser Seite einschalten.</translation>
    </message>
    <message>
        <source>The drive reports no torque: a jam cannot be seen. Connect its torque-limit output to the input Torque limit, which is monitored.</source>
        <translation>Der Antrieb meldet kein Moment: Eine Verklemmung ist nicht zu sehen. Seinen Ausgang Momentgrenze mit dem Eingang Momentgrenze verbinden, der überwacht wird.</translation>
    </message>
    <message>
        <source>The drive reports its torque too seldom: a jam cannot be seen. Connect its torque-limit output to the input Torque limit, which is monitored.</source>
        <translation>Der Antrieb meldet sein Moment zu selten: Eine Verklemmung ist nicht zu sehen. Seinen Ausgang Momentgrenze mit dem Eingang Momentgrenze verbinden, der überwacht wird.</translation>
    </message>
    <message>
        <source>Learning the torque of this program. Cycles at full speed until armed: %1</source>
        <translation>Lernt das Moment dieses Programms. Zyklen mit voller Geschwindigkeit, bis überwacht wird: %1</translation>
    </message>
    <message>
        <source>Armed. Torque beyond the band stops the machine while the jaws close.</source>
        <translation>Überwacht. Ein Moment außerhalb des Bands stoppt die Maschine, während die Backen schließen.</translation>
    </message>
    <message>
        <source>No jam since power-up.</source>
        <translation>Keine Verklemmung seit dem Einschalten.</translation>
    </message>
    <message>
        <source>%1 behind the cut</source>
        <translation>%1 nach dem Schnitt</translation>
    </message>
    <message>
        <source>%1 before the cut</source>
        <translation>%1 vor dem Schnitt</translation>
    </message>
    <message>
        <source>Torque-limit input on %1. The knife stood after another %2.</source>
        <comment>%1: a place</comment>
        <translation>Eingang Momentgrenze ein, %1. Das Messer stand nach weiteren %2.</translation>
    </message>
    <message>
        <source>Torque %1, %2; the band ends at %3. The knife stood after another %4.</source>
        <comment>%2: a place</comment>
        <translation>Moment %1, %2; das Band endet bei %3. Das Messer stand nach weiteren %4.</translation>
    </message>
    <message>
        <source>%1, for a reason that this panel does not know. Update the panel.</source>
        <comment>%1: a place</comment>
        <translation>%1, aus einem Grund, den dieses Panel nicht kennt. Panel aktualisieren.</translation>
    </message>
    <message>
        <source>Not known before the first 1000 bags.</source>
        <translation>Vor den ersten 1000 Beuteln nicht bekannt.</translation>
    </message>
    <message>
        <source>%1: mean torque at the cut of 1000 bags, less that of the first 20. It is recorded only; nothing is concluded from it.</source>
        <translation>%1: mittleres Moment am Schnitt von 1000 Beuteln, abzüglich des Werts der ersten 20. Der Wert wird nur aufgezeichnet; daraus wird nichts geschlossen.</translation>
    </message>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>Keine Daten einer Packmaschine. Steuerung verbinden und ein Rezept für einen Querschneider laden.</translation>
    </message>
    <message>
        <source>This controller does not monitor the torque of its knife. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>Diese Steuerung überwacht das Moment ihres Messers nicht. Steuerung aktualisieren: Ihre Registertabelle muss 1.6 oder neuer sein.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Jog</name>
    <message>
        <source>towards the part</source>
        <translation>zum Teil hin</translation>
    </message>
    <message>
        <source>away from the part</source>
        <translation>vom Teil weg</translation>
    </message>
    <message>
        <source>Stop ended the jog. Release the key before you jog again.</source>
        <translation>Stopp hat das Tippen beendet. Vor neuem Tippen die Taste loslassen.</translation>
    </message>
    <message>
        <source>Two keys are pressed: no motion. Release both keys.</source>
        <translation>Zwei Tasten sind gedrückt: keine Bewegung. Beide loslassen.</translation>
    </message>
    <message>
        <source>Release the key before you jog again.</source>
        <translation>Vor neuem Tippen die Taste loslassen.</translation>
    </message>
    <message>
        <source>No motion: the press does not continue against its force.</source>
        <translation>Keine Bewegung: die Presse fährt nicht gegen ihre Kraft weiter.</translation>
    </message>
    <message>
        <source>No motion. Release the key and try again.</source>
        <translation>Keine Bewegung. Taste loslassen und erneut versuchen.</translation>
    </message>
    <message>
        <source>Moves forward while you hold the key.</source>
        <translation>Fährt vorwärts, solange die Taste gehalten wird.</translation>
    </message>
    <message>
        <source>Moves in reverse while you hold the key.</source>
        <translation>Fährt rückwärts, solange die Taste gehalten wird.</translation>
    </message>
    <message>
        <source>Hold a key to turn the knife. The film stays still, and the next start begins with the reference run.</source>
        <translation>Taste halten, um das Messer zu drehen. Die Folie steht; der nächste Start referenziert zuerst.</translation>
    </message>
    <message>
        <source>Hold a key to move the ram.</source>
        <translation>Taste halten, um den Stößel zu bewegen.</translation>
    </message>
    <message>
        <source>Hold a key to move the axis.</source>
        <translation>Taste halten, um die Achse zu bewegen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::KnotModel</name>
    <message>
        <source>Knot %1, master</source>
        <translation>Stützpunkt %1, Leitachse</translation>
    </message>
    <message>
        <source>Knot %1, position</source>
        <translation>Stützpunkt %1, Position</translation>
    </message>
    <message>
        <source>The cycle closes smoothly.</source>
        <translation>Der Zyklus schließt glatt.</translation>
    </message>
    <message>
        <source>At the end of the cycle: speed jumps by %1, acceleration by %2.</source>
        <translation>Am Ende des Zyklus springt die Geschwindigkeit um %1, die Beschleunigung um %2.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LineFigures</name>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Bytes dropped</source>
        <translation>Verworfene Bytes</translation>
    </message>
    <message>
        <source>Stray bytes</source>
        <translation>Fremde Bytes</translation>
    </message>
    <message>
        <source>Line utilization</source>
        <translation>Auslastung der Leitung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>No response</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Wrong checksum</source>
        <translation>Falsche Prüfsumme</translation>
    </message>
    <message>
        <source>Damaged frame</source>
        <translation>Telegramm beschädigt</translation>
    </message>
    <message>
        <source>Refused by the controller</source>
        <translation>Von der Steuerung abgelehnt</translation>
    </message>
    <message>
        <source>Port removed</source>
        <translation>Schnittstelle entfernt</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>50 % within</source>
        <translation>50 % in</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % in</translation>
    </message>
    <message>
        <source>99 % within</source>
        <translation>99 % in</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Requests answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>link statistics</source>
        <translation>Statistik der Verbindung</translation>
    </message>
    <message>
        <source>link 24 hours</source>
        <translation>Verbindung 24 Stunden</translation>
    </message>
    <message>
        <source>Foreign response</source>
        <translation>Fremde Antwort</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>Antwort blieb aus</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LinkDoctor</name>
    <message>
        <source>A stop command is waiting for the connection and has priority.</source>
        <translation>Ein Stoppbefehl wartet auf die Verbindung und hat Vorrang.</translation>
    </message>
    <message>
        <source>A download is in progress. Wait for its end, or cancel the download.</source>
        <translation>Ein Laden läuft. Ende abwarten oder das Laden abbrechen.</translation>
    </message>
    <message>
        <source>Trying %1: %2</source>
        <comment>port, settings</comment>
        <translation>Versuch %1: %2</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>simulierte Steuerung</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>port, settings</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Diagnose tests the port in use. Search tries all ports, baud rates, parities and unit numbers, which may take long; both only read and interrupt the connection.</source>
        <translation>Diagnose prüft die benutzte Schnittstelle. Suchen probiert alle Schnittstellen, Baudraten, Paritäten und Gerätenummern, das kann dauern; beide lesen nur und unterbrechen die Verbindung.</translation>
    </message>
    <message>
        <source>Searching. The panel reconnects afterwards.</source>
        <translation>Suche läuft. Danach verbindet sich das Panel wieder.</translation>
    </message>
    <message>
        <source>Testing the port in use. The panel reconnects afterwards.</source>
        <translation>Die benutzte Schnittstelle wird geprüft. Danach verbindet sich das Panel wieder.</translation>
    </message>
    <message>
        <source>A controller responds: %1.</source>
        <translation>Eine Steuerung antwortet: %1.</translation>
    </message>
    <message>
        <source>The connection in use works: %1.</source>
        <translation>Die benutzte Verbindung arbeitet: %1.</translation>
    </message>
    <message>
        <source>Canceled. The panel reconnects automatically.</source>
        <translation>Abgebrochen. Das Panel verbindet sich selbsttätig.</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug the adapter in and search again.</source>
        <translation>Dieser Rechner hat keine serielle Schnittstelle. Adapter einstecken und erneut suchen.</translation>
    </message>
    <message>
        <source>No controller was found. Result for each port:</source>
        <translation>Keine Steuerung gefunden. Ergebnis je Schnittstelle:</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>port, what was found</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>campanel::panel::LogFilterEditor</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MarkEdgeList</name>
    <message>
        <source>taken</source>
        <translation>übernommen</translation>
    </message>
    <message>
        <source>Taken: %1. The window is ±%2.</source>
        <translation>Übernommen: %1. Das Fenster ist ±%2.</translation>
    </message>
    <message>
        <source>outside the window</source>
        <translation>außerhalb des Fensters</translation>
    </message>
    <message>
        <source>Not taken: %1; the window is ±%2. Check film and print, or widen the mark window.</source>
        <translation>Nicht übernommen: %1; das Fenster ist ±%2. Folie und Druck prüfen oder das Markenfenster verbreitern.</translation>
    </message>
    <message>
        <source>searched</source>
        <translation>gesucht</translation>
    </message>
    <message>
        <source>Searched: the controller looks for two marks at the distance of the recipe&apos;s bag length.</source>
        <translation>Gesucht: Die Steuerung sucht zwei Marken im Abstand der Beutellänge des Rezepts.</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht verwendet</translation>
    </message>
    <message>
        <source>Not used: mark tracking is off. Switch it on in the list of this page.</source>
        <translation>Nicht verwendet: Die Markenregelung ist aus. In der Liste dieser Seite einschalten.</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Not taken, for a reason that this panel does not know. Update the panel.</source>
        <translation>Nicht übernommen, aus einem Grund, den dieses Bedienfeld nicht kennt. Bedienfeld aktualisieren.</translation>
    </message>
    <message>
        <source>far from the expected mark</source>
        <translation>weit von der erwarteten Marke entfernt</translation>
    </message>
    <message>
        <source>%1 before the expected mark</source>
        <translation>%1 vor der erwarteten Marke</translation>
    </message>
    <message>
        <source>%1 behind the expected mark</source>
        <translation>%1 hinter der erwarteten Marke</translation>
    </message>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>Keine Daten einer Packmaschine. Steuerung verbinden und ein Rezept für einen Querschneider laden.</translation>
    </message>
    <message>
        <source>This controller records no edges of its mark sensor. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>Diese Steuerung zeichnet keine Flanken ihres Markensensors auf. Steuerung aktualisieren: Ihre Registertabelle muss 1.6 oder neuer sein.</translation>
    </message>
    <message>
        <source>No edges so far. Start the machine: edges are recorded while the film runs.</source>
        <translation>Noch keine Flanken. Maschine starten: Flanken werden aufgezeichnet, während die Folie läuft.</translation>
    </message>
    <message>
        <source>No edges although the film runs. Check the cable of the mark sensor and that the print passes below the sensor.</source>
        <translation>Keine Flanken, obwohl die Folie läuft. Das Kabel des Markensensors prüfen, und ob der Druck unter dem Sensor durchläuft.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>verdict: number of edges</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 edges (%2). Newest edge: %3</source>
        <translation>%1 Flanken (%2). Neueste Flanke: %3</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>zu schmal</translation>
    </message>
    <message>
        <source>Another print: narrower than a mark. If it is one, reduce the minimum width.</source>
        <translation>Anderer Druck: schmaler als eine Marke. Ist es eine, die kleinste Breite verringern.</translation>
    </message>
    <message>
        <source>too wide</source>
        <translation>zu breit</translation>
    </message>
    <message>
        <source>Another print: wider than a mark. If it is one, raise the maximum width.</source>
        <translation>Anderer Druck: breiter als eine Marke. Ist es eine, die größte Breite erhöhen.</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>Ignored: it lies in the ignored film behind the mark before it.</source>
        <translation>Ignoriert: liegt in der ignorierten Folie hinter der Marke davor.</translation>
    </message>
    <message>
        <source>%1 Its width is %2.</source>
        <comment>a sentence, a length</comment>
        <translation>%1 Breite: %2.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MarkWizard</name>
    <message>
        <source>Cut offset behind its mark</source>
        <translation>Schnitt hinter seiner Marke</translation>
    </message>
    <message>
        <source>The controller has no program for a packing machine. Download a recipe of a rotary cutter.</source>
        <translation>Die Steuerung hat kein Programm für eine Packmaschine. Ein Rezept für einen Querschneider laden.</translation>
    </message>
    <message>
        <source>Mark tracking is off. Switch mark tracking on first.</source>
        <translation>Die Markenregelung ist aus. Zuerst einschalten.</translation>
    </message>
    <message>
        <source>Waiting for the cuts to reach the marks …</source>
        <translation>Warten, bis die Schnitte die Marken erreichen …</translation>
    </message>
    <message>
        <source>Waiting for the controller …</source>
        <translation>Warten auf die Steuerung …</translation>
    </message>
    <message>
        <source>The corrected distance is outside the controller&apos;s range. Measure again.</source>
        <translation>Der korrigierte Abstand liegt außerhalb des Bereichs der Steuerung. Erneut messen.</translation>
    </message>
    <message>
        <source>The distance was written, but the cuts of the last bags deviate by %1 from their marks on average. Check gains and film before you measure again.</source>
        <translation>Der Abstand ist geschrieben, aber die Schnitte der letzten Beutel weichen im Mittel um %1 von ihren Marken ab. Verstärkungen und Folie prüfen, dann erneut messen.</translation>
    </message>
    <message>
        <source>This bag has been measured already. Wait for the next bag.</source>
        <translation>Dieser Beutel ist schon gemessen. Nächsten Beutel abwarten.</translation>
    </message>
    <message>
        <source>No bag has been cut yet.</source>
        <translation>Noch kein Beutel geschnitten.</translation>
    </message>
    <message>
        <source>The simulated machine cannot be measured now.</source>
        <translation>Die simulierte Maschine kann jetzt nicht gemessen werden.</translation>
    </message>
    <message>
        <source>The new distance is active, and the cuts of the last bags are within %1 of the target. Measure one more bag to be sure; without Save, the distance is lost at power-off.</source>
        <translation>Der neue Abstand ist aktiv, die Schnitte der letzten Beutel liegen innerhalb %1 vom Ziel. Zur Sicherheit noch einen Beutel messen; ohne Speichern geht der Abstand beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>When all cuts deviate from their marks by the same distance, the distance from mark sensor to knife is set wrong. The machine cuts a few bags, you measure the cuts from their marks, and the panel corrects the distance after you confirm.</source>
        <translation>Weichen alle Schnitte gleich weit von ihren Marken ab, ist der Abstand vom Markensensor zum Messer falsch eingestellt. Die Maschine schneidet einige Beutel, Sie messen die Schnitte ab Marke, und das Panel korrigiert nach Ihrer Bestätigung den Abstand.</translation>
    </message>
    <message>
        <source>%1 of %2 bags cut. Keep the bags in order and do not stretch them.</source>
        <translation>%1 von %2 Beuteln geschnitten. Beutel geordnet halten und nicht dehnen.</translation>
    </message>
    <message>
        <source>The measurements differ by %1. Check that all of them start at the same edge of the mark.</source>
        <translation>Die Messungen weichen um %1 voneinander ab. Prüfen, ob alle an derselben Kante der Marke beginnen.</translation>
    </message>
    <message>
        <source>This value becomes the distance from mark sensor to knife. The cuts shift over the next bags.</source>
        <translation>Dieser Wert wird der Abstand vom Markensensor zum Messer. Die Schnitte wandern über die nächsten Beutel.</translation>
    </message>
    <message>
        <source>Writing and reading back …</source>
        <translation>Schreiben und Rücklesen …</translation>
    </message>
    <message>
        <source>Written and read back. The new distance reaches the knife with bag %1 of at most %2.</source>
        <translation>Geschrieben und rückgelesen. Der neue Abstand erreicht das Messer mit Beutel %1 von höchstens %2.</translation>
    </message>
    <message>
        <source>Measure from the printed mark to the cut: positive if the cut comes after its mark, negative if the cut comes before its mark. The mean of up to %1 bags counts.</source>
        <translation>Von der gedruckten Marke zum Schnitt messen: positiv, wenn der Schnitt nach der Marke kommt, negativ, wenn davor. Das Mittel von bis zu %1 Beuteln zählt.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterDirection</name>
    <message>
        <source>This controller cannot reverse its master. Update its firmware.</source>
        <translation>Diese Steuerung kann ihre Leitachse nicht umkehren. Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>Waiting for the controller …</source>
        <translation>Warten auf die Steuerung …</translation>
    </message>
    <message>
        <source>Changing to reverse …</source>
        <translation>Wechsel auf rückwärts …</translation>
    </message>
    <message>
        <source>Changing to forward …</source>
        <translation>Wechsel auf vorwärts …</translation>
    </message>
    <message>
        <source>starts in reverse</source>
        <translation>startet rückwärts</translation>
    </message>
    <message>
        <source>starts forward</source>
        <translation>startet vorwärts</translation>
    </message>
    <message>
        <source>set to reverse</source>
        <translation>auf rückwärts gestellt</translation>
    </message>
    <message>
        <source>set to forward</source>
        <translation>auf vorwärts gestellt</translation>
    </message>
    <message>
        <source>runs in reverse</source>
        <translation>läuft rückwärts</translation>
    </message>
    <message>
        <source>runs forward</source>
        <translation>läuft vorwärts</translation>
    </message>
    <message>
        <source>Master direction</source>
        <translation>Leitrichtung</translation>
    </message>
    <message>
        <source>The line sets the direction: an encoder leads the machine.</source>
        <translation>Die Linie bestimmt die Richtung: ein Drehgeber führt die Maschine.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterFields</name>
    <message>
        <source>Phase: line ahead of the master</source>
        <translation>Phase: Linie eilt der Leitachse voraus</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Leitachse</translation>
    </message>
    <message>
        <source>Place of the encoder</source>
        <translation>Einbauort des Gebers</translation>
    </message>
    <message>
        <source>Signal of the encoder</source>
        <translation>Signal des Gebers</translation>
    </message>
    <message>
        <source>Reversed counting</source>
        <translation>Umgekehrte Zählrichtung</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Impulse pro Umdrehung</translation>
    </message>
    <message>
        <source>Film per revolution</source>
        <translation>Folie pro Umdrehung</translation>
    </message>
    <message>
        <source>Compensation of the delay</source>
        <translation>Ausgleich der Verzögerung</translation>
    </message>
    <message>
        <source>Delay of the drive</source>
        <translation>Verzögerung des Antriebs</translation>
    </message>
    <message>
        <source>Smoothing: time constant</source>
        <translation>Glättung: Zeitkonstante</translation>
    </message>
    <message>
        <source>Minimum stretch for engaging, of a cycle</source>
        <translation>Mindeststrecke zum Einkuppeln, vom Zyklus</translation>
    </message>
    <message>
        <source>Maximum speed, of the recipe&apos;s rate</source>
        <translation>Höchstgeschwindigkeit, vom Takt des Rezepts</translation>
    </message>
    <message>
        <source>Cam follows the master backward</source>
        <translation>Kurve folgt der Leitachse rückwärts</translation>
    </message>
    <message>
        <source>Index mark: tolerance</source>
        <translation>Indexmarke: Toleranz</translation>
    </message>
    <message>
        <source>Wheel: maximum slip between two marks</source>
        <translation>Messrad: maximaler Schlupf zwischen zwei Marken</translation>
    </message>
    <message>
        <source>%1 · 0: automatic</source>
        <translation>%1 · 0: automatisch</translation>
    </message>
    <message>
        <source>%1 · 0: not monitored</source>
        <translation>%1 · 0: nicht überwacht</translation>
    </message>
    <message>
        <source>This controller has no input for an encoder. Select the clock, or use a controller with such an input.</source>
        <translation>Diese Steuerung hat keinen Gebereingang. Wählen Sie den Takt der Steuerung oder verwenden Sie eine Steuerung mit Gebereingang.</translation>
    </message>
    <message>
        <source>The tolerance of the index mark would be half a revolution or more: %1 of %2 counts. Enter a smaller tolerance first.</source>
        <translation>Die Toleranz der Indexmarke wäre eine halbe Umdrehung oder mehr: %1 von %2 Impulsen. Geben Sie zuerst eine kleinere Toleranz ein.</translation>
    </message>
    <message>
        <source>0: automatic, %1 · lag %2 · noise %3</source>
        <translation>0: auto, %1 · Nachlauf %2 · Rauschen %3</translation>
    </message>
    <message>
        <source>One count is %1 of film</source>
        <translation>Ein Impuls ist %1 Folie</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterSetting</name>
    <message>
        <source>%1. Encoder at %2, phase %3.</source>
        <translation>%1. Geber bei %2, Phase %3.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::MasterWatch</name>
    <message>
        <source>Counts since power-up</source>
        <translation>Impulse seit dem Einschalten</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Ripple of the speed</source>
        <translation>Welligkeit der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Phase in use</source>
        <translation>Wirksame Phase</translation>
    </message>
    <message>
        <source>Error of the measured position</source>
        <translation>Fehler der gemessenen Position</translation>
    </message>
    <message>
        <source>Lead of the axes</source>
        <translation>Vorhalt der Achsen</translation>
    </message>
    <message>
        <source>Lag at the last cut</source>
        <translation>Nachlauf beim letzten Schnitt</translation>
    </message>
    <message>
        <source>Line waits for the master</source>
        <translation>Linie wartet auf die Leitachse</translation>
    </message>
    <message>
        <source>Film until engaged</source>
        <translation>Folie bis eingekuppelt</translation>
    </message>
    <message>
        <source>Error of the index mark</source>
        <translation>Fehler der Indexmarke</translation>
    </message>
    <message>
        <source>%1 counts</source>
        <translation>%1 Impulse</translation>
    </message>
    <message>
        <source>Slip between two marks</source>
        <translation>Schlupf zwischen zwei Marken</translation>
    </message>
    <message>
        <source>Input errors</source>
        <translation>Eingangsfehler</translation>
    </message>
    <message>
        <source>Film passed uncut</source>
        <translation>Ungeschnitten durchgelaufene Folie</translation>
    </message>
    <message>
        <source>%1 / turn</source>
        <translation>%1 / Umdr.</translation>
    </message>
    <message>
        <source>The line follows the clock of the controller.</source>
        <translation>Die Linie folgt dem Takt der Steuerung.</translation>
    </message>
    <message>
        <source>Delay: measured only while an encoder leads the line.</source>
        <translation>Verzögerung: wird nur gemessen, wenn ein Geber die Linie führt.</translation>
    </message>
    <message>
        <source>Delay: %1 cuts measured. Let the line run at least a fifth faster or slower.</source>
        <translation>Verzögerung: %1 Schnitte gemessen. Lassen Sie die Linie mindestens ein Fünftel schneller oder langsamer laufen.</translation>
    </message>
    <message>
        <source>Delay: %1 cuts measured. Let the line cut bags at a constant speed.</source>
        <translation>Verzögerung: %1 Schnitte gemessen. Lassen Sie die Linie mit konstanter Geschwindigkeit Beutel schneiden.</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2, too uncertain. Let the line run longer at two speeds.</source>
        <translation>Verzögerung: um %1 ±%2 falsch, zu unsicher. Lassen Sie die Linie länger mit zwei Geschwindigkeiten laufen.</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2. Set up offers the corrected delay.</source>
        <translation>Verzögerung: um %1 ±%2 falsch. Unter Einrichten wird die korrigierte angeboten.</translation>
    </message>
    <message>
        <source>Delay: off by %1 ±%2. No correction is needed.</source>
        <translation>Verzögerung: um %1 ±%2 falsch. Keine Korrektur nötig.</translation>
    </message>
    <message>
        <source>No data of the master. Connect the controller.</source>
        <translation>Keine Daten der Leitachse. Verbinden Sie die Steuerung.</translation>
    </message>
    <message>
        <source>This controller cannot follow an encoder. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>Diese Steuerung kann keinem Geber folgen. Aktualisieren Sie die Steuerung: Ihre Registerliste muss 1.6 oder neuer sein.</translation>
    </message>
    <message>
        <source>This controller has no input for an encoder. The line follows the clock of the controller.</source>
        <translation>Diese Steuerung hat keinen Gebereingang. Die Linie folgt dem Takt der Steuerung.</translation>
    </message>
    <message>
        <source>%1: %2 of film until engaged</source>
        <comment>%1: the state, Engaging</comment>
        <translation>%1: noch %2 Folie</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OrderEntry</name>
    <message>
        <source>bags</source>
        <translation>Beutel</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>Message before the end</source>
        <translation>Meldung vor dem Ende</translation>
    </message>
    <message>
        <source>Enter how many good bags to make.</source>
        <translation>Eingeben, wie viele gute Beutel herzustellen sind.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OrderOffers</name>
    <message>
        <source>This order is for the machine %1; this one is %2.</source>
        <translation>Dieser Auftrag ist für die Maschine %1; dies ist %2.</translation>
    </message>
    <message>
        <source>It waits in the queue, or was started already.</source>
        <translation>Er steht in der Warteschlange oder wurde schon gestartet.</translation>
    </message>
    <message>
        <source>%1 bags</source>
        <translation>%1 Beutel</translation>
    </message>
    <message>
        <source>signed by %1</source>
        <comment>person</comment>
        <translation>signiert von %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Orders</name>
    <message>
        <source>orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>%1 is complete: %2 good bags, %3 rejected, %4 empty.</source>
        <comment>%1: an order</comment>
        <translation>%1 ist fertig: %2 gute Beutel, %3 ausgeworfen, %4 leer.</translation>
    </message>
    <message>
        <source>%1: %2 bags left.</source>
        <comment>%1: an order</comment>
        <translation>%1: noch %2 Beutel.</translation>
    </message>
    <message>
        <source>The queue is full: %1 orders wait. Start or remove one first.</source>
        <translation>Die Warteschlange ist voll: %1 Aufträge warten. Zuerst einen beginnen oder entfernen.</translation>
    </message>
    <message>
        <source>The panel&apos;s database is not open yet. Try again.</source>
        <translation>Die Datenbank des Panels ist noch nicht offen. Erneut versuchen.</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>Es besteht keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>The controller has no program for a packing machine. Download a recipe first.</source>
        <translation>Die Steuerung hat kein Programm für eine Verpackungsmaschine. Zuerst ein Rezept laden.</translation>
    </message>
    <message>
        <source>The controller&apos;s order is being read. Try again.</source>
        <translation>Der Auftrag der Steuerung wird gelesen. Erneut versuchen.</translation>
    </message>
    <message>
        <source>An order is under way. End it first.</source>
        <translation>Ein Auftrag läuft. Beenden Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>This order is for %1, and the controller has %2. Download %1 first.</source>
        <comment>recipes</comment>
        <translation>Dieser Auftrag ist für %1, und die Steuerung hat %2. Zuerst %1 laden.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::OutputTry</name>
    <message>
        <source>A filled lamp means on. This controller cannot try outputs; update its firmware.</source>
        <translation>Gefüllte Lampe: ein. Diese Steuerung kann keine Ausgänge testen; ihre Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>%1 is on while you hold the key.</source>
        <translation>%1 ist ein, solange Sie die Taste halten.</translation>
    </message>
    <message>
        <source>Release the key before you try again.</source>
        <translation>Taste loslassen, bevor Sie erneut testen.</translation>
    </message>
    <message>
        <source>A filled lamp means on. Hold Try to switch an output on.</source>
        <translation>Gefüllte Lampe: ein. Testen halten, um einen Ausgang einzuschalten.</translation>
    </message>
    <message>
        <source>A filled lamp means on. Outputs can be tried at standstill.</source>
        <translation>Gefüllte Lampe: ein. Ausgänge lassen sich im Stillstand testen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingFields</name>
    <message>
        <source>Knife: max. speed step at a change</source>
        <translation>Messer: max. Geschw.-Sprung bei Wechsel</translation>
    </message>
    <message>
        <source>Film: max. speed step at a change</source>
        <translation>Folie: max. Geschw.-Sprung bei Wechsel</translation>
    </message>
    <message>
        <source>Infeed: max. speed step at a change</source>
        <translation>Zuführung: max. Geschw.-Sprung bei Wechsel</translation>
    </message>
    <message>
        <source>Mark tracking</source>
        <translation>Markenregelung</translation>
    </message>
    <message>
        <source>Phase gain: correction of slip</source>
        <translation>Phasenverstärkung: Schlupfkorrektur</translation>
    </message>
    <message>
        <source>Length gain: correction of length</source>
        <translation>Längenverstärkung: Längenkorrektur</translation>
    </message>
    <message>
        <source>Mark sensor to knife</source>
        <translation>Markensensor bis Messer</translation>
    </message>
    <message>
        <source>Cut offset behind its mark</source>
        <translation>Schnitt hinter seiner Marke</translation>
    </message>
    <message>
        <source>Mark window, ±</source>
        <translation>Markenfenster, ±</translation>
    </message>
    <message>
        <source>Missing marks in a row before stop</source>
        <translation>Fehlende Marken bis zum Stopp</translation>
    </message>
    <message>
        <source>Phase limit: max. shift of a cut</source>
        <translation>Phasengrenze: max. Schnittversatz</translation>
    </message>
    <message>
        <source>Length limit: max. change of a bag</source>
        <translation>Längengrenze: max. Beuteländerung</translation>
    </message>
    <message>
        <source>Length trim without marks</source>
        <translation>Längentrimm ohne Marken</translation>
    </message>
    <message>
        <source>Anti-cut: knife stays open over product</source>
        <translation>Produktschutz: Messer bleibt offen</translation>
    </message>
    <message>
        <source>Clearance on both sides of a cut</source>
        <translation>Freiraum beiderseits des Schnitts</translation>
    </message>
    <message>
        <source>Skipped cuts in a row before stop</source>
        <translation>Ausgelassene Schnitte bis zum Stopp</translation>
    </message>
    <message>
        <source>Film waits for a missing product</source>
        <translation>Folie wartet auf fehlendes Produkt</translation>
    </message>
    <message>
        <source>Product placement to knife</source>
        <translation>Produktablage bis Messer</translation>
    </message>
    <message>
        <source>Product eye to placement</source>
        <translation>Produktlichtschranke bis Ablage</translation>
    </message>
    <message>
        <source>Product pitch on the infeed</source>
        <translation>Produktabstand der Zuführung</translation>
    </message>
    <message>
        <source>Infeed motor: pulses per product</source>
        <translation>Zuführmotor: Pulse je Produkt</translation>
    </message>
    <message>
        <source>Film motor: film per revolution</source>
        <translation>Folienmotor: Folie je Umdrehung</translation>
    </message>
    <message>
        <source>Film motor: pulses per revolution</source>
        <translation>Folienmotor: Pulse je Umdrehung</translation>
    </message>
    <message>
        <source>%1 · no suggestion: the mark positions do not vary (%2 bags)</source>
        <translation>%1 · kein Vorschlag: die Marken schwanken nicht (%2 Beutel)</translation>
    </message>
    <message>
        <source>%1 · margin ±%5: film slip %2 per bag, sensor std dev %3 (%4 bags)</source>
        <translation>%1 · Spanne ±%5: Folienschlupf %2 je Beutel, Sensor-Std.-abw. %3 (%4 Beutel)</translation>
    </message>
    <message>
        <source>%1 · too few bags for a suggestion, still needed: %2</source>
        <translation>%1 · zu wenige Beutel für einen Vorschlag, noch nötig: %2</translation>
    </message>
    <message>
        <source>Mark sensor: dead time</source>
        <translation>Markensensor: Totzeit</translation>
    </message>
    <message>
        <source>Product eye: dead time, product comes</source>
        <translation>Produktlichtschranke: Totzeit, Produkt kommt</translation>
    </message>
    <message>
        <source>Product eye: dead time, product ends</source>
        <translation>Produktlichtschranke: Totzeit, Produkt endet</translation>
    </message>
    <message>
        <source>%1 · learned from starts, stops and changes of rate: too few marks so far</source>
        <translation>%1 · wird aus Anläufen, Stopps und Taktwechseln gelernt: noch zu wenige Marken</translation>
    </message>
    <message>
        <source>%1 · learned: %2 ms, margin ±%3 ms</source>
        <translation>%1 · gelernt: %2 ms, Unsicherheit ±%3 ms</translation>
    </message>
    <message>
        <source>%1. It answers later than entered: clean and check it.</source>
        <translation>%1. Er antwortet später als eingetragen: reinigen und prüfen.</translation>
    </message>
    <message>
        <source>Knife %1 cuts behind its place by</source>
        <translation>Messer %1 schneidet hinter seinem Platz um</translation>
    </message>
    <message>
        <source>Mark sensor: more dead time at a mark&apos;s end</source>
        <translation>Markensensor: mehr Totzeit am Ende einer Marke</translation>
    </message>
    <message>
        <source>Mark width, minimum</source>
        <translation>Markenbreite, kleinste</translation>
    </message>
    <message>
        <source>Mark width, maximum</source>
        <translation>Markenbreite, größte</translation>
    </message>
    <message>
        <source>Ignored film behind a mark</source>
        <translation>Ignorierte Folie hinter einer Marke</translation>
    </message>
    <message>
        <source>Product length, maximum</source>
        <translation>Produktlänge, größte</translation>
    </message>
    <message>
        <source>Jaws close before the cut by</source>
        <translation>Backen schließen vor dem Schnitt um</translation>
    </message>
    <message>
        <source>Jaws open behind the cut by</source>
        <translation>Backen öffnen nach dem Schnitt um</translation>
    </message>
    <message>
        <source>Delay before the knife opens after a stop</source>
        <translation>Verzögerung, bis das Messer nach Halt öffnet</translation>
    </message>
    <message>
        <source>Closed jaws spoil the film after</source>
        <translation>Geschlossene Backen verderben die Folie nach</translation>
    </message>
    <message>
        <source>No mark would fit: at least %1, at most %2. Change the other one first.</source>
        <translation>Keine Marke würde passen: mindestens %1, höchstens %2. Zuerst den anderen Wert ändern.</translation>
    </message>
    <message>
        <source>Thread up: knife open until a mark is there</source>
        <translation>Einfädeln: Messer offen, bis eine Marke da ist</translation>
    </message>
    <message>
        <source>%1 · 0: not used</source>
        <translation>%1 · 0: nicht verwendet</translation>
    </message>
    <message>
        <source>Jam detection: stop at once at a jam</source>
        <translation>Klemmerkennung: bei Verklemmung sofort stoppen</translation>
    </message>
    <message>
        <source>Jam detection: knife closes before the cut by</source>
        <translation>Klemmerkennung: Messer schließt vor dem Schnitt um</translation>
    </message>
    <message>
        <source>Jam detection: margin beyond the torque band</source>
        <translation>Klemmerkennung: Abstand zum Momentband</translation>
    </message>
    <message>
        <source>Jam: time from full speed to standstill</source>
        <translation>Verklemmung: Zeit von voller Geschwindigkeit zum Stillstand</translation>
    </message>
    <message>
        <source>Jam: knife goes back by</source>
        <translation>Verklemmung: Messer fährt zurück um</translation>
    </message>
    <message>
        <source>The jaws would stay closed after a jam: they close %1° before the cut. The knife must go back by more than that.</source>
        <translation>Die Backen blieben nach einer Verklemmung geschlossen: Sie schließen %1° vor dem Schnitt. Das Messer muss weiter zurückfahren.</translation>
    </message>
    <message>
        <source>Too short for the knife: with its maximum acceleration it needs %1 ms from its speed at the cut. Enter at least that time.</source>
        <translation>Zu kurz für das Messer: Mit seiner größten Beschleunigung braucht es %1 ms ab der Geschwindigkeit am Schnitt. Mindestens diese Zeit eingeben.</translation>
    </message>
    <message>
        <source>%1 · to measure this, fix one part on the infeed and run at two speeds</source>
        <translation>%1 · zum Messen ein Teil auf der Zuführung befestigen und mit zwei Geschwindigkeiten fahren</translation>
    </message>
    <message>
        <source>%1 · not offered: margin ±%2 ms, at most %3 ms. Fix one part on the infeed and run at two speeds.</source>
        <translation>%1 · kein Vorschlag: Unsicherheit ±%2 ms, höchstens %3 ms. Ein Teil auf der Zuführung befestigen und mit zwei Geschwindigkeiten fahren.</translation>
    </message>
    <message>
        <source>%1 · measured: %2 ms, margin ±%3 ms</source>
        <translation>%1 · gemessen: %2 ms, Unsicherheit ±%3 ms</translation>
    </message>
    <message>
        <source>The end of a mark would have a dead time of %1 ms; it must be 0 to %2 ms. Change the other time first.</source>
        <translation>Das Ende einer Marke hätte %1 ms Totzeit; möglich sind 0 bis %2 ms. Zuerst die andere Zeit ändern.</translation>
    </message>
    <message>
        <source>%1 · leaves out the cut: enter both angles, or 0 for both</source>
        <translation>%1 · lässt den Schnitt aus: beide Winkel eingeben, oder bei beiden 0</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PackingSetup</name>
    <message>
        <source>No packing machine data. Connect the controller and download a recipe of a rotary cutter.</source>
        <translation>Keine Daten einer Packmaschine. Steuerung verbinden und ein Rezept für einen Querschneider laden.</translation>
    </message>
    <message>
        <source>Waiting: marks are measured while the film runs.</source>
        <translation>Warten: Marken werden bei laufender Folie gemessen.</translation>
    </message>
    <message>
        <source>%1 of %2 marks measured …</source>
        <translation>%1 von %2 Marken gemessen …</translation>
    </message>
    <message>
        <source>Measures the distances of the next %1 marks while the machine runs.</source>
        <translation>Misst bei laufender Maschine die Abstände der nächsten %1 Marken.</translation>
    </message>
    <message>
        <source>Start the machine: marks are measured while the film runs, with mark tracking on or off.</source>
        <translation>Maschine starten: Marken werden bei laufender Folie gemessen, mit oder ohne Markenregelung.</translation>
    </message>
    <message>
        <source>The mark distance is %1 (±%2), the recipe cuts %3. The difference exceeds the length limit: this film does not match this recipe.</source>
        <translation>Der Markenabstand ist %1 (±%2), das Rezept schneidet %3. Die Differenz überschreitet die Längengrenze: diese Folie passt nicht zum Rezept.</translation>
    </message>
    <message>
        <source>The mark distance is %1 (±%2), the recipe cuts %3.</source>
        <translation>Der Markenabstand ist %1 (±%2), das Rezept schneidet %3.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::PagedLogBase</name>
    <message>
        <source>Only the newest %1 rows are exported. Set a time by the filter for older ones.</source>
        <translation>Nur die neuesten %1 Zeilen werden exportiert. Für ältere im Filter eine Zeit wählen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ParameterField</name>
    <message>
        <source>Jog speed</source>
        <translation>Tippgeschw.</translation>
    </message>
    <message>
        <source>Reference run speed</source>
        <translation>Referenzgeschw.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ParameterFields</name>
    <message>
        <source>Writing %1: %2 …</source>
        <translation>%1 wird geschrieben: %2 …</translation>
    </message>
    <message>
        <source>%1: %2, read back from the controller.</source>
        <translation>%1: %2, von der Steuerung rückgelesen.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Not in this controller. Update its firmware.</source>
        <translation>Nicht in dieser Steuerung. Ihre Firmware aktualisieren.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramDownload</name>
    <message>
        <source>Not possible: the machine cannot execute this recipe.</source>
        <translation>Nicht möglich: die Maschine kann dieses Rezept nicht ausführen.</translation>
    </message>
    <message>
        <source>Not possible: this controller cannot execute this kind of program.</source>
        <translation>Nicht möglich: diese Steuerung kann diese Programmart nicht ausführen.</translation>
    </message>
    <message>
        <source>Controller: unknown</source>
        <translation>Steuerung: unbekannt</translation>
    </message>
    <message>
        <source>Controller: reading the program …</source>
        <translation>Steuerung: Programm wird gelesen …</translation>
    </message>
    <message>
        <source>The controller has no program</source>
        <translation>Die Steuerung hat kein Programm</translation>
    </message>
    <message>
        <source>Active in controller: generation %1</source>
        <translation>In der Steuerung aktiv: Generation %1</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · identical</source>
        <translation>In der Steuerung aktiv: Generation %1 · gleich</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · 1 value differs</source>
        <translation>In der Steuerung aktiv: Generation %1 · 1 Wert anders</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · %2 values differ</source>
        <translation>In der Steuerung aktiv: Generation %1 · %2 Werte anders</translation>
    </message>
    <message>
        <source>No connection. Last known program in the controller: generation %1</source>
        <translation>Keine Verbindung. Letztes bekanntes Programm der Steuerung: Generation %1</translation>
    </message>
    <message>
        <source>The controller already has this program.</source>
        <translation>Die Steuerung hat dieses Programm schon.</translation>
    </message>
    <message>
        <source>The new recipe is used from the next start.</source>
        <translation>Das neue Rezept gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>%1 Confirm the advance, or close the cam.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Vorschub bestätigen oder Kurve schließen.</translation>
    </message>
    <message>
        <source>Active in controller: generation %1 · another kind of program</source>
        <translation>In der Steuerung aktiv: Generation %1 · andere Programmart</translation>
    </message>
    <message>
        <source>Not possible: the disk with the data of this machine is missing. The controller keeps its program.</source>
        <translation>Nicht möglich: Der Datenträger mit den Daten dieser Maschine fehlt. Die Steuerung behält ihr Programm.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ProgramProof</name>
    <message>
        <source>The controller has no program. Download a recipe first.</source>
        <translation>Die Steuerung hat kein Programm. Zuerst ein Rezept laden.</translation>
    </message>
    <message>
        <source>The connection is lost. The comparison continues when it is restored.</source>
        <translation>Die Verbindung ist verloren. Der Vergleich geht danach weiter.</translation>
    </message>
    <message>
        <source>Reading the table back from the controller …</source>
        <translation>Die Tabelle wird aus der Steuerung zurückgelesen …</translation>
    </message>
    <message>
        <source>Reads back and compares every register of the table, also while the machine runs.</source>
        <translation>Liest jedes Register der Tabelle zurück und vergleicht, auch im Lauf.</translation>
    </message>
    <message>
        <source>what this panel downloaded</source>
        <translation>dem von diesem Panel Geladenen</translation>
    </message>
    <message>
        <source>the table computed again from its recipe</source>
        <translation>der aus dem Rezept neu berechneten Tabelle</translation>
    </message>
    <message>
        <source>the controller&apos;s own checksum</source>
        <translation>der Prüfsumme der Steuerung</translation>
    </message>
    <message>
        <source>Identical: the table of generation %1 matches %2. CRC-32 %3.</source>
        <comment>%2: &quot;the controller&apos;s own checksum&quot;</comment>
        <translation>Gleich: die Tabelle der Generation %1 stimmt mit %2 überein. CRC-32 %3.</translation>
    </message>
    <message>
        <source>Identical: all %1 registers of generation %2 match %3. CRC-32 %4.</source>
        <comment>%3: for example &quot;what this panel downloaded&quot;</comment>
        <translation>Gleich: alle %1 Register der Generation %2 stimmen mit %3 überein. CRC-32 %4.</translation>
    </message>
    <message>
        <source>The controller&apos;s program changed during the comparison. Compare again.</source>
        <translation>Das Programm der Steuerung änderte sich während des Vergleichs. Erneut vergleichen.</translation>
    </message>
    <message>
        <source>Canceled without a result.</source>
        <translation>Ohne Ergebnis abgebrochen.</translation>
    </message>
    <message>
        <source>Different: the table read back has CRC-32 %1, the controller reports %2. Download the recipe again.</source>
        <translation>Verschieden: die rückgelesene Tabelle hat CRC-32 %1, die Steuerung meldet %2. Rezept erneut laden.</translation>
    </message>
    <message>
        <source>first %1: %2 instead of %3</source>
        <comment>register: its value, expected value</comment>
        <translation>zuerst %1: %2 statt %3</translation>
    </message>
    <message>
        <source>Different: 1 of %1 registers does not match %2, %3. Download the recipe again.</source>
        <translation>Verschieden: 1 von %1 Registern weicht ab von %2, %3. Rezept erneut laden.</translation>
    </message>
    <message>
        <source>Different: %1 of %2 registers do not match %3, %4. Download the recipe again.</source>
        <translation>Verschieden: %1 von %2 Registern weichen ab von %3, %4. Rezept erneut laden.</translation>
    </message>
    <message>
        <source>Not compared: there is no connection to the controller.</source>
        <translation>Nicht verglichen: keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>Not compared: another comparison is in progress.</source>
        <translation>Nicht verglichen: ein anderer Vergleich läuft.</translation>
    </message>
    <message>
        <source>Not compared. %1</source>
        <comment>%1: whole sentence</comment>
        <translation>Nicht verglichen. %1</translation>
    </message>
    <message>
        <source>register %1 of the rows</source>
        <translation>Register %1 der Zeilen</translation>
    </message>
    <message>
        <source>no program</source>
        <translation>kein Programm</translation>
    </message>
    <message>
        <source>generation %1, CRC-32 %2</source>
        <translation>Generation %1, CRC-32 %2</translation>
    </message>
    <message>
        <source>%1 · v%2, generation %3, CRC-32 %4</source>
        <translation>%1 · v%2, Generation %3, CRC-32 %4</translation>
    </message>
    <message>
        <source>none: no program after a power loss</source>
        <translation>keines: nach Stromausfall kein Programm</translation>
    </message>
    <message>
        <source>identical: kept after a power loss</source>
        <translation>gleich: bleibt nach Stromausfall</translation>
    </message>
    <message>
        <source>different, CRC-32 %1: restored after a power loss</source>
        <translation>anders, CRC-32 %1: gilt nach Stromausfall</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RampControl</name>
    <message>
        <source>Peak acceleration</source>
        <translation>Max. Beschleunigung</translation>
    </message>
    <message>
        <source>RMS acceleration</source>
        <translation>Effektive Beschleunigung</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>Max. Drehzahl</translation>
    </message>
    <message>
        <source>Highest rate</source>
        <translation>Höchste Taktzahl</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1/min</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Ratios: %1 %</source>
        <comment>position between slow and gentle</comment>
        <translation>Verhältnisse: %1 %</translation>
    </message>
    <message>
        <source>Ratios: %1</source>
        <comment>set by hand, gentle, cool or slow</comment>
        <translation>Verhältnisse: %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ReasonEditor</name>
    <message>
        <source>Enter a name.</source>
        <translation>Geben Sie einen Namen ein.</translation>
    </message>
    <message>
        <source>The name is longer than %1 letters.</source>
        <translation>Der Name ist länger als %1 Zeichen.</translation>
    </message>
    <message>
        <source>The name cannot contain a slash.</source>
        <translation>Der Name darf keinen Schrägstrich enthalten.</translation>
    </message>
    <message>
        <source>This name is already in the list.</source>
        <translation>Dieser Name ist schon in der Liste.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeCodes</name>
    <message>
        <source>Any reel</source>
        <translation>Jede Rolle</translation>
    </message>
    <message>
        <source>The code is too long. Enter at most %1 letters and digits.</source>
        <translation>Der Code ist zu lang. Höchstens %1 Buchstaben und Ziffern eingeben.</translation>
    </message>
    <message>
        <source>The code has characters that cannot be printed. Enter letters and digits.</source>
        <translation>Der Code hat Zeichen, die nicht druckbar sind. Buchstaben und Ziffern eingeben.</translation>
    </message>
    <message>
        <source>This is the code of the recipe %1. Enter another code.</source>
        <translation>Dies ist der Code des Rezepts %1. Anderen Code eingeben.</translation>
    </message>
    <message>
        <source>This is the code of the film reel of %1. Enter another code.</source>
        <translation>Dies ist der Code der Folienrolle von %1. Anderen Code eingeben.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeFiles</name>
    <message>
        <source>cannot be used · %1 · %2</source>
        <comment>date, place</comment>
        <translation>nicht verwendbar · %1 · %2</translation>
    </message>
    <message>
        <source>%1 Correct the file; the panel reads it again automatically.</source>
        <comment>%1: whole sentence</comment>
        <translation>%1 Datei korrigieren; das Panel liest sie selbsttätig neu.</translation>
    </message>
    <message>
        <source>This panel cannot show all letters of the name; missing: %1. Rename the recipe after importing.</source>
        <translation>Dieses Panel kann nicht alle Buchstaben des Namens anzeigen; es fehlen: %1. Das Rezept nach dem Import umbenennen.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>whole sentences</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Offered: %1</source>
        <comment>recipe and version</comment>
        <translation>Angeboten: %1</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <comment>recipe, number</comment>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>signed by %1</source>
        <comment>person</comment>
        <translation>signiert von %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeWindow</name>
    <message>
        <source>%1, lowest</source>
        <comment>name of a value</comment>
        <translation>%1, kleinster Wert</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <comment>name of a value</comment>
        <translation>%1, größter Wert</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RecipeWindows</name>
    <message>
        <source>%1: the lowest value is above the highest. Correct one of them.</source>
        <translation>%1: Der kleinste Wert liegt über dem größten. Einen von beiden korrigieren.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Recipes</name>
    <message>
        <source>No version of these recipes can be read: %1. Restore a backup that has them.</source>
        <translation>Von diesen Rezepten ist keine Version lesbar: %1. Stellen Sie eine Sicherung wieder her, die sie enthält.</translation>
    </message>
    <message>
        <source>%1 was imported as %2, version %3.</source>
        <comment>file, recipe</comment>
        <translation>%1 wurde als %2, Version %3, importiert.</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <comment>date, person</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 · version %2, %3</source>
        <comment>kind of program, number, when it was saved</comment>
        <translation>%1 · Version %2, %3</translation>
    </message>
    <message>
        <source>%1 · Version %2 cannot be read. Check this version, then save it.</source>
        <comment>note, number</comment>
        <translation>%1 · Version %2 ist nicht lesbar. Diese Version prüfen, dann speichern.</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Einen Namen eingeben.</translation>
    </message>
    <message>
        <source>The name is too long. Enter at most %1 letters, or a third as many Chinese characters.</source>
        <translation>Der Name ist zu lang. Höchstens %1 Buchstaben oder ein Drittel so viele chinesische Zeichen eingeben.</translation>
    </message>
    <message>
        <source>A recipe with this name already exists.</source>
        <translation>Ein Rezept mit diesem Namen gibt es schon.</translation>
    </message>
    <message>
        <source>Saved: %1, version %2.</source>
        <translation>Gespeichert: %1, Version %2.</translation>
    </message>
    <message>
        <source>%1 was created with default values and opened. Set your values on the Motion page.</source>
        <translation>%1 wurde mit Standardwerten angelegt und geöffnet. Werte auf der Seite Bewegung einstellen.</translation>
    </message>
    <message>
        <source>%1 was created as a copy and opened.</source>
        <translation>%1 wurde als Kopie angelegt und geöffnet.</translation>
    </message>
    <message>
        <source>A deleted recipe has the name %1. Choose another name.</source>
        <translation>Ein gelöschtes Rezept heißt %1. Anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Renamed %1 to %2.</source>
        <translation>%1 wurde in %2 umbenannt.</translation>
    </message>
    <message>
        <source>%1 was deleted; its versions are kept.</source>
        <translation>%1 wurde gelöscht; seine Versionen bleiben.</translation>
    </message>
    <message>
        <source>%1 · v%2</source>
        <translation>%1 · v%2</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>The file becomes the new recipe %1. The data of this machine stay unchanged.</source>
        <translation>Die Datei wird das neue Rezept %1. Die Daten dieser Maschine bleiben unverändert.</translation>
    </message>
    <message>
        <source>The file is identical to %1, version %2; nothing changes.</source>
        <translation>Die Datei gleicht %1, Version %2; nichts ändert sich.</translation>
    </message>
    <message>
        <source>The file becomes version %2 of %1; earlier versions are kept.</source>
        <translation>Die Datei wird Version %2 von %1; frühere Versionen bleiben.</translation>
    </message>
    <message>
        <source>%1 Changes: %2.</source>
        <comment>whole sentence, list</comment>
        <translation>%1 Änderungen: %2.</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <comment>name, old value, new value</comment>
        <translation>%1 %2 auf %3</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between changes</comment>
        <translation>; </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <comment>list</comment>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is a %2 on this panel and a %3 in the file. Rename one of them.</source>
        <translation>%1 ist auf diesem Panel %2 und in der Datei %3. Eines davon umbenennen.</translation>
    </message>
    <message>
        <source>The file has version %2 of %1; this panel has version %3. An older version is not imported; open it from the versions of the recipe.</source>
        <translation>Die Datei hat Version %2 von %1; dieses Panel hat Version %3. Eine ältere Version wird nicht importiert; aus den Versionen des Rezepts öffnen.</translation>
    </message>
    <message>
        <source>This machine cannot run the recipe. %1</source>
        <comment>whole sentences</comment>
        <translation>Diese Maschine kann das Rezept nicht ausführen. %1</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>Peak motor torque</source>
        <translation>Höchstes Motormoment</translation>
    </message>
    <message>
        <source>RMS motor torque</source>
        <translation>Effektives Motormoment</translation>
    </message>
    <message>
        <source>Highest RMS torque</source>
        <translation>Höchstes Effektivmoment</translation>
    </message>
    <message>
        <source>%1, %2 Nm</source>
        <comment>recipe, torque</comment>
        <translation>%1, %2 Nm</translation>
    </message>
    <message>
        <source>The file of the open recipe was lost or damaged. Opened instead: %1, version %2, with this panel&apos;s machine data.</source>
        <translation>Die Datei des offenen Rezepts war verloren oder beschädigt. Stattdessen geöffnet: %1, Version %2, mit den Maschinendaten dieses Panels.</translation>
    </message>
    <message>
        <source>The machine data for %1 were lost or damaged. Those saved with the recipe %2 are used; check them on the Motion page.</source>
        <translation>Die Maschinendaten für %1 waren verloren oder beschädigt. Die mit dem Rezept %2 gespeicherten gelten; auf der Seite Bewegung prüfen.</translation>
    </message>
    <message>
        <source>The name has characters that nobody can see. Enter the name again.</source>
        <translation>Der Name enthält unsichtbare Zeichen. Den Namen neu eingeben.</translation>
    </message>
    <message numerus="yes">
        <source>%n recipes were imported.</source>
        <translation>
            <numerusform>%n Rezept wurde importiert.</numerusform>
            <numerusform>%n Rezepte wurden importiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>new</source>
        <comment>recipe</comment>
        <translation>neu</translation>
    </message>
    <message>
        <source>is here already</source>
        <comment>recipe</comment>
        <translation>schon vorhanden</translation>
    </message>
    <message>
        <source>becomes version %1</source>
        <translation>wird Version %1</translation>
    </message>
    <message>
        <source>The file of the open recipe was lost or damaged. Opened instead: a new recipe, with this panel&apos;s machine data.</source>
        <translation>Die Datei des offenen Rezepts war verloren oder beschädigt. Stattdessen geöffnet: ein neues Rezept, mit den Maschinendaten dieses Panels.</translation>
    </message>
    <message>
        <source>%1 is in the list again.</source>
        <translation>%1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>The recipe %1 is not among the recipes of this panel. Save it first.</source>
        <translation>Das Rezept %1 ist nicht unter den Rezepten dieses Bediengeräts. Speichern Sie es zuerst.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RegisterInspector</name>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>Tap a register to read its description or to write a value.</source>
        <translation>Ein Register antippen, um seine Beschreibung zu lesen oder einen Wert zu schreiben.</translation>
    </message>
    <message>
        <source>Writable: %1 to %2, default %3.</source>
        <translation>Schreibbar: %1 bis %2, Standard %3.</translation>
    </message>
    <message>
        <source>There is no connection to the controller.</source>
        <translation>Keine Verbindung zur Steuerung.</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>Written and read back from the controller: %1.</source>
        <translation>Geschrieben und von der Steuerung rückgelesen: %1.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::RegisterModel</name>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ReportFiles</name>
    <message>
        <source>New files will be written to %1.</source>
        <translation>Neue Dateien werden nach %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Scan</name>
    <message>
        <source>The prefix is not possible. Enter up to 8 letters, digits or signs of ASCII without spaces.</source>
        <translation>Dieses Präfix ist nicht möglich. Bis zu 8 Buchstaben, Ziffern oder Zeichen in ASCII ohne Leerzeichen eingeben.</translation>
    </message>
    <message>
        <source>The code was not read completely. Scan again.</source>
        <translation>Der Code wurde nicht vollständig gelesen. Erneut scannen.</translation>
    </message>
    <message>
        <source>No recipe has the code %1. Enter the code with its recipe on the Recipes page.</source>
        <translation>Kein Rezept hat den Code %1. Den Code auf der Seite Rezepte beim Rezept eingeben.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same code %3. Give one of them another code.</source>
        <translation>%1 und %2 haben denselben Code %3. Einem davon einen anderen Code geben.</translation>
    </message>
    <message>
        <source>An entry is open. Confirm or cancel the entry, then scan again.</source>
        <translation>Eine Eingabe ist offen. Die Eingabe bestätigen oder abbrechen, dann erneut scannen.</translation>
    </message>
    <message>
        <source>Complete the first start, then scan again.</source>
        <translation>Zuerst den ersten Start abschließen, dann erneut scannen.</translation>
    </message>
    <message>
        <source>The recipes are still being read. Scan again.</source>
        <translation>Die Rezepte werden noch gelesen. Erneut scannen.</translation>
    </message>
    <message>
        <source>A download is running. Scan again when the download has ended.</source>
        <translation>Eine Übertragung läuft. Nach ihrem Ende erneut scannen.</translation>
    </message>
    <message>
        <source>Film reel %1 is the right one for this recipe.</source>
        <translation>Folienrolle %1 ist die richtige für dieses Rezept.</translation>
    </message>
    <message>
        <source>Film reel %1 is loaded. The next recipe is compared with it.</source>
        <translation>Folienrolle %1 ist eingelegt. Das nächste Rezept wird damit verglichen.</translation>
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
        <translation>Endet bei</translation>
    </message>
    <message>
        <source>End position</source>
        <translation>Endposition</translation>
    </message>
    <message>
        <source>Start speed</source>
        <translation>Anfangsgeschw.</translation>
    </message>
    <message>
        <source>Start acceleration</source>
        <translation>Anfangsbeschl.</translation>
    </message>
    <message>
        <source>End speed</source>
        <translation>Endgeschw.</translation>
    </message>
    <message>
        <source>End acceleration</source>
        <translation>Endbeschl.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ServiceBundle</name>
    <message>
        <source>CamPanel service %1</source>
        <comment>name of a file</comment>
        <translation>CamPanel Service %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Settings</name>
    <message>
        <source>Unit number</source>
        <translation>Gerätenummer</translation>
    </message>
    <message>
        <source>Permission denied: add the user to the group &quot;%1&quot;.</source>
        <translation>Keine Berechtigung: Benutzer der Gruppe „%1“ hinzufügen.</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing. The last good copy is used; check the settings.</source>
        <translation>Die Einstellungsdatei war beschädigt oder fehlte. Die letzte gute Kopie wird verwendet; Einstellungen prüfen.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Glove mode</source>
        <translation>Handschuhe</translation>
    </message>
    <message>
        <source>bag tolerance, mm</source>
        <translation>Beuteltoleranz, mm</translation>
    </message>
    <message>
        <source>minutes until logout</source>
        <translation>Minuten bis zur Abmeldung</translation>
    </message>
    <message>
        <source>operator login required</source>
        <translation>Bediener müssen sich anmelden</translation>
    </message>
    <message>
        <source>hold to start</source>
        <translation>zum Starten halten</translation>
    </message>
    <message>
        <source>seconds of a stop until its question</source>
        <translation>Sekunden eines Stillstands bis zur Frage</translation>
    </message>
    <message>
        <source>ideal rate, pieces/min</source>
        <translation>ideale Taktrate, Stück/min</translation>
    </message>
    <message>
        <source>start of the shifts</source>
        <translation>Beginn der Schichten</translation>
    </message>
    <message>
        <source>working days</source>
        <translation>Arbeitstage</translation>
    </message>
    <message>
        <source>reasons of a stop</source>
        <translation>Stillstandsgründe</translation>
    </message>
    <message>
        <source>scanner prefix</source>
        <translation>Präfix des Scanners</translation>
    </message>
    <message>
        <source>scanner suffix</source>
        <translation>Suffix des Scanners</translation>
    </message>
    <message>
        <source>time between scanned keys, ms</source>
        <translation>Zeit zwischen Tasten des Scanners, ms</translation>
    </message>
    <message>
        <source>screen rotation, degrees</source>
        <translation>Bildschirmdrehung, Grad</translation>
    </message>
    <message>
        <source>The settings file was damaged or missing and has no good copy. No controller is selected: select one on the Settings page, under Connection.</source>
        <translation>Die Einstellungsdatei war beschädigt oder fehlte, ohne gute Kopie. Keine Steuerung gewählt: auf der Seite Einstellungen unter Verbindung wählen.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Screen off without touch, at standstill</source>
        <translation>Bildschirm aus ohne Berührung, im Stillstand</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Bag tolerance</source>
        <translation>Beuteltoleranz</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>Log out after</source>
        <translation>Abmelden nach</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Without login</source>
        <translation>Ohne Anmeldung</translation>
    </message>
    <message>
        <source>Start key</source>
        <translation>Starttaste</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Selbsttätig</translation>
    </message>
    <message>
        <source>hold with a real controller</source>
        <translation>halten bei echter Steuerung</translation>
    </message>
    <message>
        <source>Hold for 0.5 s</source>
        <translation>0,5 s halten</translation>
    </message>
    <message>
        <source>an accidental touch does not start the machine</source>
        <translation>eine zufällige Berührung startet die Maschine nicht</translation>
    </message>
    <message>
        <source>One touch</source>
        <translation>Eine Berührung</translation>
    </message>
    <message>
        <source>Suffix</source>
        <translation>Suffix</translation>
    </message>
    <message>
        <source>Enter key</source>
        <translation>Eingabetaste</translation>
    </message>
    <message>
        <source>Tab key</source>
        <translation>Tabulatortaste</translation>
    </message>
    <message>
        <source>Time between keys</source>
        <translation>Zeit zwischen Tasten</translation>
    </message>
    <message>
        <source>Question after</source>
        <translation>Frage nach</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Ideal rate</source>
        <translation>Ideale Taktrate</translation>
    </message>
    <message>
        <source>by recipe</source>
        <translation>nach Rezept</translation>
    </message>
    <message>
        <source>pieces/min</source>
        <translation>Stück/min</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Metrisch</translation>
    </message>
    <message>
        <source>mm, mm/s, m/s²</source>
        <translation>mm, mm/s, m/s²</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>in, in/s, ft; files stay metric</source>
        <translation>in, in/s, ft; Dateien bleiben metrisch</translation>
    </message>
    <message>
        <source>This text is not possible. Enter up to 64 visible characters.</source>
        <translation>Dieser Text ist nicht möglich. Höchstens 64 sichtbare Zeichen eingeben.</translation>
    </message>
    <message>
        <source>By date</source>
        <translation>Nach Datum</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Name</translation>
    </message>
    <message>
        <source>By last use</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>step of a trim, mm</source>
        <translation>Schritt eines Trimms, mm</translation>
    </message>
    <message>
        <source>Step of a trim</source>
        <translation>Schritt eines Trimms</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ShiftReport</name>
    <message>
        <source>shift %1</source>
        <comment>name of a file: date and time</comment>
        <translation>Schicht %1</translation>
    </message>
    <message>
        <source>Shift report</source>
        <translation>Schichtbericht</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Effectiveness</source>
        <translation>Effektivität</translation>
    </message>
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
    <message>
        <source>Run time</source>
        <translation>Laufzeit</translation>
    </message>
    <message>
        <source>Planned time</source>
        <translation>Geplante Zeit</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>Planned stops</source>
        <translation>Geplante Stillstände</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Good pieces</source>
        <translation>Gute Stücke</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Außer Toleranz</translation>
    </message>
    <message>
        <source>Start-up scrap</source>
        <translation>Anfahrausschuss</translation>
    </message>
    <message>
        <source>Skipped cuts</source>
        <translation>Ausgelassene Schnitte</translation>
    </message>
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
    <message>
        <source>%1, %2</source>
        <comment>time, duration</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>reason, person</comment>
        <translation>%1 (%2)</translation>
    </message>
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
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Programs that ran</source>
        <translation>Gelaufene Programme</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Stops answered by</source>
        <translation>Stillstände beantwortet von</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>%1, %2; rejected %3, empty %4; %5</source>
        <comment>bags, state, counts, further facts of an order</comment>
        <translation>%1, %2; ausgeworfen %3, leer %4; %5</translation>
    </message>
    <message>
        <source>No order in this shift.</source>
        <translation>Kein Auftrag in dieser Schicht.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::ShiftView</name>
    <message>
        <source>ddd d MMM</source>
        <comment>date: weekday, day, month</comment>
        <translation>ddd d. MMM</translation>
    </message>
    <message>
        <source>%1, %2 – %3</source>
        <comment>date, begin and end of a shift</comment>
        <translation>%1, %2 – %3</translation>
    </message>
    <message>
        <source>Day off: no production planned</source>
        <translation>Freier Tag: keine Produktion geplant</translation>
    </message>
    <message>
        <source>Present shift</source>
        <translation>Laufende Schicht</translation>
    </message>
    <message>
        <source>Run %1 · stops %2 · planned stops %3</source>
        <translation>Lauf %1 · Stillstände %2 · geplant %3</translation>
    </message>
    <message>
        <source>Run %1 · stops %2 · planned stops %3 · not recorded %4</source>
        <translation>Lauf %1 · Stillstände %2 · geplant %3 · nicht aufgezeichnet %4</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>time, duration, reason of a stop</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>states</source>
        <translation>Zustände</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SimulatedFaults</name>
    <message>
        <source>Late responses</source>
        <translation>Späte Antworten</translation>
    </message>
    <message>
        <source>Responses arrive 1.5 timeouts late, after the next request.</source>
        <translation>Antworten kommen 1,5 Wartezeiten zu spät, nach der nächsten Anfrage.</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>Verlorene Telegramme</translation>
    </message>
    <message>
        <source>Requests and responses that never arrive.</source>
        <translation>Anfragen und Antworten, die nie ankommen.</translation>
    </message>
    <message>
        <source>Corrupted responses</source>
        <translation>Verfälschte Antworten</translation>
    </message>
    <message>
        <source>Flipped bits and truncated responses.</source>
        <translation>Gekippte Bits und abgeschnittene Antworten.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Random bytes after the responses.</source>
        <translation>Zufällige Bytes nach den Antworten.</translation>
    </message>
    <message>
        <source>A second master</source>
        <translation>Zweiter Master</translation>
    </message>
    <message>
        <source>Its valid responses arrive in place of the panel&apos;s.</source>
        <translation>Seine gültigen Antworten kommen an Stelle der eigenen.</translation>
    </message>
    <message>
        <source>Responses of other devices</source>
        <translation>Antworten anderer Geräte</translation>
    </message>
    <message>
        <source>Wrong unit, wrong function, wrong length.</source>
        <translation>Falsches Gerät, falsche Funktion, falsche Länge.</translation>
    </message>
    <message>
        <source>Busy controller</source>
        <translation>Steuerung beschäftigt</translation>
    </message>
    <message>
        <source>The controller refuses three requests in a row.</source>
        <translation>Die Steuerung lehnt drei Anfragen nacheinander ab.</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>Stille</translation>
    </message>
    <message>
        <source>No data passes for two seconds.</source>
        <translation>Zwei Sekunden lang keine Daten.</translation>
    </message>
    <message>
        <source>Unplugged adapter</source>
        <translation>Adapter abgezogen</translation>
    </message>
    <message>
        <source>The port disappears for two seconds.</source>
        <translation>Die Schnittstelle verschwindet zwei Sekunden lang.</translation>
    </message>
    <message>
        <source>Restarts of the controller</source>
        <translation>Neustarts der Steuerung</translation>
    </message>
    <message>
        <source>Silence, then power-on with the saved program. The machine stops.</source>
        <translation>Stille, dann Einschalten mit dem gespeicherten Programm. Die Maschine hält an.</translation>
    </message>
    <message>
        <source>Another register map</source>
        <translation>Anderer Registerplan</translation>
    </message>
    <message>
        <source>Takes effect when the panel reconnects, after another fault.</source>
        <translation>Wirkt beim nächsten Verbinden, nach einem anderen Fehler.</translation>
    </message>
    <message>
        <source>No faults: the connection works without errors.</source>
        <translation>Keine Fehler: die Verbindung arbeitet fehlerfrei.</translation>
    </message>
    <message>
        <source>Active: %1</source>
        <translation>Aktiv: %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>The simulated controller refused the fault: %1</source>
        <translation>Die simulierte Steuerung hat den Fehler abgelehnt: %1</translation>
    </message>
    <message>
        <source>Faults are available for the simulated controller only.</source>
        <translation>Fehler gibt es nur bei der simulierten Steuerung.</translation>
    </message>
    <message>
        <source>The simulated controller is not running. Connect it, then try again.</source>
        <translation>Die simulierte Steuerung läuft nicht. Verbinden und erneut versuchen.</translation>
    </message>
    <message>
        <source>Something under the jaws</source>
        <translation>Etwas unter den Backen</translation>
    </message>
    <message>
        <source>A packing machine with jam detection stops. Off: taken out.</source>
        <translation>Eine Packmaschine mit Klemmerkennung stoppt. Aus: entfernt.</translation>
    </message>
    <message>
        <source>Line runs</source>
        <translation>Linie läuft</translation>
    </message>
    <message>
        <source>The shaft with the encoder. 100 %: %1, the active program at its rate.</source>
        <translation>Die Welle mit dem Drehgeber. 100 %: %1, das aktive Programm mit seiner Taktzahl.</translation>
    </message>
    <message>
        <source>Wheel slips</source>
        <translation>Messrad rutscht</translation>
    </message>
    <message>
        <source>The encoder turns 5 % less than the line travels.</source>
        <translation>Der Drehgeber dreht 5 % weniger, als die Linie läuft.</translation>
    </message>
    <message>
        <source>Counts lost</source>
        <translation>Impulse verloren</translation>
    </message>
    <message>
        <source>The encoder loses 50 counts in each revolution.</source>
        <translation>Der Drehgeber verliert 50 Impulse je Umdrehung.</translation>
    </message>
    <message>
        <source>Wires swapped</source>
        <translation>Adern vertauscht</translation>
    </message>
    <message>
        <source>A and B of the encoder: the counts go backward.</source>
        <translation>A und B des Drehgebers: die Zählung läuft rückwärts.</translation>
    </message>
    <message>
        <source>Encoder signal disturbed</source>
        <translation>Gebersignal gestört</translation>
    </message>
    <message>
        <source>A and B change at once at 2 % of the edges.</source>
        <translation>A und B wechseln bei 2 % der Flanken zugleich.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SoftwareUpdate</name>
    <message>
        <source>Updates are installed by the package manager of this computer.</source>
        <translation>Aktualisierungen installiert die Paketverwaltung dieses Rechners.</translation>
    </message>
    <message>
        <source>The panel closes, installs this version and comes back.</source>
        <translation>Das Panel schließt, installiert diese Version und kommt wieder.</translation>
    </message>
    <message>
        <source>CamPanel %1</source>
        <comment>version</comment>
        <translation>CamPanel %1</translation>
    </message>
    <message>
        <source>cannot be used: %1 · %2</source>
        <comment>reason, place</comment>
        <translation>nicht verwendbar: %1 · %2</translation>
    </message>
    <message>
        <source>signed by %1, %2 · %3</source>
        <comment>person, date, place</comment>
        <translation>signiert von %1, %2 · %3</translation>
    </message>
    <message>
        <source>CamPanel was not installed as a package. Install it once by the package manager.</source>
        <translation>CamPanel wurde nicht als Paket installiert. Installieren Sie es einmal mit der Paketverwaltung.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Update to %1</source>
        <comment>version</comment>
        <translation>Auf %1 aktualisieren</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <comment>version</comment>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2, which cannot read the present data. Recipes, users, settings and records become those of %3; what was saved since then is put aside on this panel.</source>
        <translation>CamPanel %1 wird durch %2 ersetzt, das die jetzigen Daten nicht lesen kann. Rezepte, Benutzer, Einstellungen und Aufzeichnungen werden die vom %3; was seither gespeichert wurde, wird auf diesem Panel beiseitegelegt.</translation>
    </message>
    <message>
        <source>Preparing … The panel closes soon and comes back.</source>
        <translation>Wird vorbereitet … Das Panel schließt bald und kommt wieder.</translation>
    </message>
    <message>
        <source>Not updated: %1</source>
        <translation>Nicht aktualisiert: %1</translation>
    </message>
    <message>
        <source>The update did not begin. Read journalctl -u campanel-update.</source>
        <translation>Die Aktualisierung hat nicht begonnen. Lesen Sie journalctl -u campanel-update.</translation>
    </message>
    <message>
        <source>Nothing was installed. %1</source>
        <comment>%1: whole sentences</comment>
        <translation>Es wurde nichts installiert. %1</translation>
    </message>
    <message>
        <source>CamPanel %1 could not be used. %2 The panel has put %3 and its data back.</source>
        <comment>version, whole sentences, version</comment>
        <translation>CamPanel %1 war nicht verwendbar. %2 Das Panel hat %3 mit seinen Daten wiederhergestellt.</translation>
    </message>
    <message>
        <source>CamPanel %1 could not be installed, and %2 could not be put back completely. Install CamPanel by the package manager. %3</source>
        <comment>version, version, whole sentences</comment>
        <translation>CamPanel %1 ließ sich nicht installieren, und %2 ließ sich nicht vollständig wiederherstellen. Installieren Sie CamPanel mit der Paketverwaltung. %3</translation>
    </message>
    <message>
        <source>Updated from %1 to %2.</source>
        <translation>Von %1 auf %2 aktualisiert.</translation>
    </message>
    <message>
        <source>Back from %1 to %2, with the data from before the update.</source>
        <translation>Von %1 zurück zu %2, mit den Daten von vor der Aktualisierung.</translation>
    </message>
    <message>
        <source>Back from %1 to %2.</source>
        <translation>Von %1 zurück zu %2.</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2. The panel closes for some minutes; the controller keeps its program. If the new version does not start, the panel puts %1 and its data back.</source>
        <translation>CamPanel %1 wird durch %2 ersetzt. Das Panel schließt für einige Minuten; die Steuerung behält ihr Programm. Startet die neue Version nicht, stellt das Panel %1 mit seinen Daten wieder her.</translation>
    </message>
    <message>
        <source>CamPanel %1 is replaced by %2. The panel closes for some minutes. Recipes and records stay.</source>
        <translation>CamPanel %1 wird durch %2 ersetzt. Das Panel schließt für einige Minuten. Rezepte und Aufzeichnungen bleiben.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::StartPermit</name>
    <message>
        <source>Start only with permit</source>
        <translation>Start nur mit Freigabe</translation>
    </message>
    <message>
        <source>On: no start that the panel blocks.</source>
        <translation>Ein: kein Start, den das Panel sperrt.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::StopSetup</name>
    <message>
        <source>every day</source>
        <translation>täglich</translation>
    </message>
    <message>
        <source>standard list</source>
        <translation>Standardliste</translation>
    </message>
    <message>
        <source>own list (%1)</source>
        <translation>eigene Liste (%1)</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Stops</name>
    <message>
        <source>Since %1, %2</source>
        <comment>time, duration</comment>
        <translation>Seit %1, %2</translation>
    </message>
    <message>
        <source>Stop reason: %1.</source>
        <translation>Stillstandsgrund: %1.</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <comment>time</comment>
        <translation>Stillstand seit %1</translation>
    </message>
    <message>
        <source>Last stop %1</source>
        <comment>time</comment>
        <translation>Letzter Stillstand %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemClock</name>
    <message>
        <source>Asking the operating system …</source>
        <translation>Das Betriebssystem wird gefragt …</translation>
    </message>
    <message>
        <source>systemd-timedated does not respond. Set the clock in the operating system.</source>
        <translation>systemd-timedated antwortet nicht. Stellen Sie die Uhr im Betriebssystem.</translation>
    </message>
    <message>
        <source>The clock is set by hand.</source>
        <translation>Die Uhr wird von Hand gestellt.</translation>
    </message>
    <message>
        <source>The clock follows a time server.</source>
        <translation>Die Uhr folgt einem Zeitserver.</translation>
    </message>
    <message>
        <source>No time server has responded yet. Check the network.</source>
        <translation>Noch kein Zeitserver hat geantwortet. Prüfen Sie das Netzwerk.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemNetwork</name>
    <message>
        <source>Setting the address of %1. This takes up to a minute.</source>
        <translation>Die Adresse von %1 wird eingestellt. Das dauert bis zu einer Minute.</translation>
    </message>
    <message>
        <source>Asking the operating system …</source>
        <translation>Das Betriebssystem wird gefragt …</translation>
    </message>
    <message>
        <source>NetworkManager does not respond. Set the network in the operating system.</source>
        <translation>NetworkManager antwortet nicht. Stellen Sie das Netzwerk im Betriebssystem ein.</translation>
    </message>
    <message>
        <source>NetworkManager manages no network port. Set the network in the operating system.</source>
        <translation>NetworkManager verwaltet keinen Netzwerkanschluss. Stellen Sie das Netzwerk im Betriebssystem ein.</translation>
    </message>
    <message>
        <source>%1 is not connected. Plug in the network cable.</source>
        <translation>%1 ist nicht verbunden. Stecken Sie das Netzkabel ein.</translation>
    </message>
    <message>
        <source>%1 has no address yet.</source>
        <translation>%1 hat noch keine Adresse.</translation>
    </message>
    <message>
        <source>%1 has the address %2.</source>
        <translation>%1 hat die Adresse %2.</translation>
    </message>
    <message>
        <source>%1 did not get this address; the previous one is restored. Check the cable, and that no other device has the address.</source>
        <translation>%1 hat diese Adresse nicht bekommen; die vorige gilt wieder. Prüfen Sie das Kabel, und ob ein anderes Gerät die Adresse hat.</translation>
    </message>
    <message>
        <source>No DHCP server responded; the previous address is restored. Check the cable, or enter a fixed address.</source>
        <translation>Kein DHCP-Server hat geantwortet; die vorige Adresse gilt wieder. Prüfen Sie das Kabel, oder geben Sie eine feste Adresse ein.</translation>
    </message>
    <message>
        <source>The previous address was not restored: %1. Set the network in the operating system.</source>
        <translation>Die vorige Adresse wurde nicht wiederhergestellt: %1. Stellen Sie das Netzwerk im Betriebssystem ein.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::SystemService</name>
    <message>
        <source>The operating system does not allow the panel to do this. Install polkit and the rule of the CamPanel package.</source>
        <translation>Das Betriebssystem erlaubt dies dem Panel nicht. Installieren Sie polkit und die Regel des CamPanel-Pakets.</translation>
    </message>
    <message>
        <source>Not set: %1</source>
        <translation>Nicht gestellt: %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TorqueWatch</name>
    <message>
        <source>The drive reports no torque.</source>
        <translation>Der Antrieb meldet kein Moment.</translation>
    </message>
    <message>
        <source>Inertia and rated torque are missing in Settings, Machine.</source>
        <translation>Trägheit und Nennmoment fehlen unter Einstellungen, Maschine.</translation>
    </message>
    <message>
        <source>The inertia is missing in Settings, Machine.</source>
        <translation>Die Trägheit fehlt unter Einstellungen, Maschine.</translation>
    </message>
    <message>
        <source>The rated torque is missing in Settings, Machine.</source>
        <translation>Das Nennmoment fehlt unter Einstellungen, Maschine.</translation>
    </message>
    <message>
        <source>The program was made for other machine data.</source>
        <translation>Das Programm wurde für andere Maschinendaten erstellt.</translation>
    </message>
    <message>
        <source>Torque %1 % of rated, predicted %2 %, largest difference %3 %</source>
        <translation>Moment %1 % vom Nennmoment, vorhergesagt %2 %, größte Differenz %3 %</translation>
    </message>
    <message>
        <source>Torque %1 %, predicted %2 %, max. diff. %3 %</source>
        <translation>Moment %1 %, vorhergesagt %2 %, max. Diff. %3 %</translation>
    </message>
    <message>
        <source>Torque %1 %</source>
        <translation>Moment %1 %</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TouchCalibration</name>
    <message>
        <source>The calibration was not set. Read journalctl -u campanel-touch.</source>
        <translation>Die Kalibrierung wurde nicht gesetzt. Siehe journalctl -u campanel-touch.</translation>
    </message>
    <message>
        <source>The touchscreen is calibrated in the operating system of this computer.</source>
        <translation>Der Touchscreen wird im Betriebssystem dieses Rechners kalibriert.</translation>
    </message>
    <message>
        <source>This computer has no touchscreen.</source>
        <translation>Dieser Rechner hat keinen Touchscreen.</translation>
    </message>
    <message>
        <source>The panel closes, sets the calibration and comes back.</source>
        <translation>Das Panel schließt, setzt die Kalibrierung und öffnet sich wieder.</translation>
    </message>
    <message>
        <source>A cross was missed. Touch the center of each cross.</source>
        <translation>Ein Kreuz wurde verfehlt. Die Mitte jedes Kreuzes berühren.</translation>
    </message>
    <message>
        <source>The touches do not fit the screen. Touch each cross where it is shown.</source>
        <translation>Die Berührungen passen nicht zum Bildschirm. Jedes Kreuz dort berühren, wo es steht.</translation>
    </message>
    <message>
        <source>Not set: %1</source>
        <translation>Nicht gesetzt: %1</translation>
    </message>
    <message>
        <source>The earlier calibration of the touchscreen did not return. %1</source>
        <translation>Die frühere Kalibrierung des Touchscreens kam nicht zurück. %1</translation>
    </message>
</context>
<context>
    <name>campanel::panel::TowerFields</name>
    <message>
        <source>No data of the light tower. Connect the controller.</source>
        <translation>Keine Daten der Signalsäule. Steuerung verbinden.</translation>
    </message>
    <message>
        <source>This controller has no light tower. Update the controller: its register map must be 1.6 or newer.</source>
        <translation>Diese Steuerung hat keine Signalsäule. Steuerung aktualisieren: Die Registertabelle muss 1.6 oder neuer sein.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>Hupe</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Trends</name>
    <message>
        <source>bags</source>
        <translation>Beutel</translation>
    </message>
    <message>
        <source>trends</source>
        <translation>Trends</translation>
    </message>
    <message>
        <source>Single bags are left out: more than %1. Show a shorter time.</source>
        <translation>Einzelne Beutel fehlen: mehr als %1. Einen kürzeren Zeitraum anzeigen.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Value</name>
    <message>
        <source>Enter a number.</source>
        <translation>Eine Zahl eingeben.</translation>
    </message>
    <message>
        <source>The minimum is %1.</source>
        <translation>Das Minimum ist %1.</translation>
    </message>
    <message>
        <source>The maximum is %1.</source>
        <translation>Das Maximum ist %1.</translation>
    </message>
</context>
<context>
    <name>campanel::panel::Versions</name>
    <message>
        <source>%1, version %2</source>
        <comment>recipe, number</comment>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>firmware %1, register map %2.%3, serial number %4</source>
        <translation>Firmware %1, Registerplan %2.%3, Seriennummer %4</translation>
    </message>
    <message>
        <source>not known yet: measured from the second day on</source>
        <translation>noch nicht bekannt: gemessen ab dem zweiten Tag</translation>
    </message>
    <message>
        <source>%1 MB a day</source>
        <translation>%1 MB am Tag</translation>
    </message>
    <message>
        <source>%1; the disk lasts more than 100 years</source>
        <comment>growth</comment>
        <translation>%1; die Festplatte reicht mehr als 100 Jahre</translation>
    </message>
    <message>
        <source>%1; the disk lasts %2 years</source>
        <comment>growth, number</comment>
        <translation>%1; die Festplatte reicht %2 Jahre</translation>
    </message>
    <message>
        <source>The disk lasts for less than five years. Free some disk space, or use a larger disk.</source>
        <translation>Die Festplatte reicht für weniger als fünf Jahre. Speicherplatz freigeben oder eine größere Festplatte verwenden.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1, CRC-32 %2</source>
        <comment>number, number</comment>
        <translation>%1, CRC-32 %2</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>%1 GB frei</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>unknown: not connected</source>
        <translation>unbekannt: nicht verbunden</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Active program</source>
        <translation>Aktives Programm</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>Generation</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Geöffnetes Rezept</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Zuwachs</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <comment>recipe</comment>
        <translation>%1, nicht gespeichert</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
</context>
<context>
    <name>campanel::panel::WindowReason</name>
    <message>
        <source>Outside the approved window: %1. Give a reason, or enter an approved value.</source>
        <translation>Außerhalb des freigegebenen Bereichs: %1. Grund angeben oder einen freigegebenen Wert eingeben.</translation>
    </message>
    <message>
        <source>%1: since %2, %3</source>
        <comment>values, time, reason</comment>
        <translation>%1: seit %2, %3</translation>
    </message>
    <message>
        <source>%1: by %2 since %3, %4</source>
        <comment>values, person, time, reason</comment>
        <translation>%1: durch %2 seit %3, %4</translation>
    </message>
    <message>
        <source>%1: no reason given.</source>
        <comment>values</comment>
        <translation>%1: kein Grund angegeben.</translation>
    </message>
    <message>
        <source>Enter the reason for the audit trail.</source>
        <translation>Grund für das Änderungsprotokoll eingeben.</translation>
    </message>
    <message>
        <source>A reason has at most %1 characters. Shorten it.</source>
        <translation>Ein Grund hat höchstens %1 Zeichen. Bitte kürzen.</translation>
    </message>
    <message>
        <source>The reason has characters that nobody can see. Remove them.</source>
        <translation>Der Grund enthält unsichtbare Zeichen. Diese entfernen.</translation>
    </message>
</context>
</TS>
