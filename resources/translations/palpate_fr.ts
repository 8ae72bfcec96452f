<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>CoordinatesChoice</name>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y haut</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 supposé</translation>
    </message>
    <message>
        <source>Coordinates: %1</source>
        <translation>Coordonnées&#x202f;: %1</translation>
    </message>
    <message>
        <source>File axes point left, posterior and superior, as in DICOM</source>
        <translation>Axes des fichiers&#x202f;: gauche, arrière, tête, comme en DICOM</translation>
    </message>
    <message>
        <source>File axes point right, anterior and superior, as in older 3D Slicer models</source>
        <translation>Axes des fichiers&#x202f;: droite, avant, tête, comme dans les anciens modèles de 3D Slicer</translation>
    </message>
    <message>
        <source>File axes point left, superior and anterior, as in 3D modelling programs</source>
        <translation>Axes des fichiers&#x202f;: gauche, tête, avant, comme dans les modeleurs 3D</translation>
    </message>
    <message>
        <source>The files use %1 coordinates.</source>
        <translation>Les fichiers utilisent les coordonnées %1.</translation>
    </message>
    <message>
        <source>Some files do not state their axes. %1 is assumed; left and right may be swapped. Click to choose the axes.</source>
        <translation>Certains fichiers n’indiquent pas leurs axes. %1 est supposé&#x202f;; gauche et droite peuvent être inversées. Cliquer pour choisir les axes.</translation>
    </message>
    <message>
        <source>The surfaces belong to a recording and keep their recorded coordinates.</source>
        <translation>Les surfaces appartiennent à un enregistrement et gardent leurs coordonnées.</translation>
    </message>
    <message>
        <source>Coordinates of the files</source>
        <translation>Coordonnées des fichiers</translation>
    </message>
    <message>
        <source>LPS: left, posterior, superior</source>
        <translation>LPS&#x202f;: gauche, postérieur, supérieur</translation>
    </message>
    <message>
        <source>RAS: right, anterior, superior</source>
        <translation>RAS&#x202f;: droite, antérieur, supérieur</translation>
    </message>
    <message>
        <source>Y up: left, superior, anterior</source>
        <translation>Y vers le haut&#x202f;: gauche, supérieur, antérieur</translation>
    </message>
</context>
<context>
    <name>FeltLayers</name>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
    <message>
        <source>holds %1 N</source>
        <translation>adhère %1&#xa0;N</translation>
    </message>
    <message>
        <source>slides %1 N</source>
        <translation>glisse %1&#xa0;N</translation>
    </message>
    <message>
        <source>%1 N, pressed in %2 mm</source>
        <translation>%1 N, enfoncé de %2 mm</translation>
    </message>
</context>
<context>
    <name>FindingType</name>
    <message>
        <source>lump</source>
        <translation>nodule</translation>
    </message>
    <message>
        <source>hard area</source>
        <translation>zone dure</translation>
    </message>
    <message>
        <source>soft area</source>
        <translation>zone molle</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>keep away</source>
        <translation>à éviter</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
</context>
<context>
    <name>FindingsDesk</name>
    <message>
        <source>Finding %1</source>
        <translation>Point %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Note %1</translation>
    </message>
    <message>
        <source>%1 was not marked in a recording.</source>
        <translation>%1 n’a pas été marqué dans un enregistrement.</translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation>
            <numerusform>Importer %n point repéré</numerusform>
            <numerusform>Importer %n points repérés</numerusform>
        </translation>
    </message>
    <message>
        <source>, stiffness %1</source>
        <translation>, rigidité %1</translation>
    </message>
    <message>
        <source>Nothing is touched. Press on a place first, then mark a finding (M).</source>
        <translation>Rien n’est touché. Appuyer d’abord à un endroit, puis marquer un point (M).</translation>
    </message>
    <message>
        <source>%1 marked on %2 at %3 N</source>
        <translation>%1 marqué sur %2 à %3 N</translation>
    </message>
    <message>
        <source>No findings yet. Press on a place, then mark a finding (M).</source>
        <translation>Aucun point repéré. Appuyer à un endroit, puis marquer un point (M).</translation>
    </message>
    <message>
        <source>%1 has no saved view.</source>
        <translation>%1 n’a pas de vue enregistrée.</translation>
    </message>
    <message>
        <source>Recording in progress. Stop recording (R) before playing.</source>
        <translation>Enregistrement en cours. L’arrêter (R) avant de lire.</translation>
    </message>
    <message>
        <source>%1: the recording with %2 was not found.</source>
        <translation>%1&#x202f;: l’enregistrement avec %2 est introuvable.</translation>
    </message>
    <message>
        <source>%1: this is not the recording in which %2 was marked.</source>
        <translation>%1&#x202f;: ce n’est pas l’enregistrement dans lequel %2 a été marqué.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) exported to %1</source>
        <translation>
            <numerusform>%n point repéré exporté dans %1</numerusform>
            <numerusform>%n points repérés exportés dans %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) imported from %1</source>
        <translation>
            <numerusform>%n point repéré importé de %1</numerusform>
            <numerusform>%n points repérés importés de %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LumpLayout</name>
    <message>
        <source>%1: inside %2, felt as a layer below %2 (%3)</source>
        <translation>%1&#x202f;: dans %2, palpable comme une couche sous %2 (%3)</translation>
    </message>
    <message>
        <source>surface open or inside out</source>
        <translation>surface ouverte ou retournée</translation>
    </message>
    <message>
        <source>%1 is also a lump</source>
        <translation>%1 est aussi un nodule</translation>
    </message>
    <message>
        <source>the name %1 is not unique</source>
        <translation>le nom %1 n’est pas unique</translation>
    </message>
    <message>
        <source>extends beyond %1</source>
        <translation>dépasse de %1</translation>
    </message>
    <message>
        <source>stiffness map on the lump or on %1</source>
        <translation>carte de raideur sur le nodule ou sur %1</translation>
    </message>
    <message>
        <source>stiffness ratio to %1 unknown: enter a ratio under What can be felt (B)</source>
        <translation>rapport de raideur à %1 inconnu&#x202f;: à saisir sous «&#x202f;Ce qui se sent&#x202f;» (B)</translation>
    </message>
    <message>
        <source>same stiffness as %1</source>
        <translation>même raideur que %1</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt through it, %3 times as stiff (%4)</source>
        <translation>%1 se trouve dans %2 et est palpable à travers, %3 fois plus raide (%4)</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Recherche, formation et répétition du geste planifié. Pas un dispositif médical.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Taille du texte</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Séance</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aid&amp;e</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Quit Palpate</source>
        <translation>Quitter Palpate</translation>
    </message>
</context>
<context>
    <name>MeasuresDialog</name>
    <message>
        <source>Data table (CSV)</source>
        <translation>Tableau (CSV)</translation>
    </message>
    <message>
        <source>Data table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Path and map for 3D Slicer</source>
        <translation>Trajet et carte pour 3D Slicer</translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation>VTK poly data (*.vtp)</translation>
    </message>
    <message>
        <source>Results (JSON)</source>
        <translation>Résultats (JSON)</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>Résultats (*.json)</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Résultats de %1</translation>
    </message>
    <message>
        <source>Results of the session</source>
        <translation>Résultats de la séance</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Written to %1 and %2.</source>
        <translation>Écrit dans %1 et %2.</translation>
    </message>
    <message>
        <source>Result of the last export</source>
        <translation>Résultat du dernier export</translation>
    </message>
    <message>
        <source>Export progress</source>
        <translation>Progression de l’export</translation>
    </message>
    <message>
        <source>Cancel export</source>
        <translation>Annuler l’export</translation>
    </message>
    <message>
        <source>Copy all tables for a spreadsheet (Ctrl+C)</source>
        <translation>Copier tous les tableaux pour un tableur (Ctrl+C)</translation>
    </message>
    <message>
        <source>Every sample with time, positions, forces, depth and events</source>
        <translation>Chaque échantillon avec temps, positions, forces, profondeur et événements</translation>
    </message>
    <message>
        <source>Path of the hand, plus the touched surface with time spent and peak force</source>
        <translation>Trajet de la main, et surface touchée avec temps passé et force maximale</translation>
    </message>
    <message>
        <source>All results in machine-readable form</source>
        <translation>Tous les résultats sous forme lisible par un programme</translation>
    </message>
    <message>
        <source>Copied. Paste into a spreadsheet.</source>
        <translation>Copié. Coller dans un tableur.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 already exists. Enter the full file name to replace the file.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 existe déjà. Pour remplacer le fichier, saisir le nom complet.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 ends in %2. For %3, enter a name that ends in %4.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 finit par %2. Pour %3, saisir un nom qui finit par %4.</translation>
    </message>
    <message>
        <source>The path was written to %1, but the surface was not: %2</source>
        <translation>Le trajet a été écrit dans %1, mais pas la surface&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>OwnThreshold</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>for your hand: felt</source>
        <translation>pour votre main&#x202f;: palpable</translation>
    </message>
    <message>
        <source>for your hand: not felt</source>
        <translation>pour votre main&#x202f;: non palpable</translation>
    </message>
</context>
<context>
    <name>RecordingControl</name>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>● recording %1, %2</source>
        <translation>● enregistre %1, %2</translation>
    </message>
    <message>
        <source>recording failed at %1</source>
        <translation>échec de l’enregistrement à %1</translation>
    </message>
    <message>
        <source>Length of the recording [min:s]. Late samples (1 ms each): the computer was too busy and nothing was felt. Lost samples: felt, but not recorded because the disk was too slow.</source>
        <translation>Durée de l’enregistrement [min:s]. Échantillons en retard (1 ms chacun)&#x202f;: l’ordinateur était surchargé, rien n’a été senti. Échantillons perdus&#x202f;: sentis, mais non enregistrés car le disque était trop lent.</translation>
    </message>
    <message>
        <source>Recording in progress. Stop recording and close?</source>
        <translation>Enregistrement en cours. L’arrêter et fermer&#x202f;?</translation>
    </message>
    <message>
        <source>The recording so far is kept in %1.</source>
        <translation>L’enregistrement réalisé jusqu’ici est conservé dans %1.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Continue recording</source>
        <translation>Continuer l’enregistrement</translation>
    </message>
    <message>
        <source>● recording %1, disk not responding</source>
        <translation>● enregistre %1, le disque ne répond pas</translation>
    </message>
    <message>
        <source>%1 stopped: write error</source>
        <translation>%1 arrêté&#x202f;: erreur d’écriture</translation>
    </message>
</context>
<context>
    <name>ResultTables</name>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>En contact</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation>Trajet de la main</translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation>Trajet en surface</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Force and depth</source>
        <translation>Force et profondeur</translation>
    </message>
    <message>
        <source>Time spent [s]</source>
        <translation>Temps passé [s]</translation>
    </message>
    <message>
        <source>Mean [N]</source>
        <translation>Moyenne [N]</translation>
    </message>
    <message>
        <source>Median [N]</source>
        <translation>Médiane [N]</translation>
    </message>
    <message>
        <source>Peak [N]</source>
        <translation>Maximum [N]</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Appuis</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phases</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Appui</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation>Aire [cm²]</translation>
    </message>
    <message>
        <source>Examined [%]</source>
        <translation>Examiné [%]</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Points repérés</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Marqué</translation>
    </message>
    <message>
        <source>First touched</source>
        <translation>Premier toucher</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrite</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>pas à la main</translation>
    </message>
    <message>
        <source>Predicted by the model [%]</source>
        <translation>Prédit par le modèle [%]</translation>
    </message>
    <message>
        <source>Late samples</source>
        <translation>Échantillons en retard</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Échantillons perdus</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>95th percentile [N]</source>
        <translation>95ᵉ centile [N]</translation>
    </message>
    <message>
        <source>Maximum depth [mm]</source>
        <translation>Profondeur max. [mm]</translation>
    </message>
    <message>
        <source>Searching and pressing</source>
        <translation>Recherche et appui</translation>
    </message>
    <message>
        <source>Examined share of the surface (within %1, the fingertip radius)</source>
        <translation>Part examinée de la surface (à moins de %1, le rayon du bout du doigt)</translation>
    </message>
    <message>
        <source>Examined share of the surface (within %1)</source>
        <translation>Part examinée de la surface (à moins de %1)</translation>
    </message>
    <message>
        <source>Longest time at one point [s]</source>
        <translation>Temps maximal en un point [s]</translation>
    </message>
    <message>
        <source>mesh not found</source>
        <translation>maillage introuvable</translation>
    </message>
    <message>
        <source>Revisits</source>
        <translation>Retours</translation>
    </message>
    <message>
        <source>Lumps: recorded response and model prediction (estimate)</source>
        <translation>Nodules&#x202f;: réponse enregistrée et prédiction du modèle (estimation)</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Palpable by a trained hand [cm²]</source>
        <translation>Palpable par une main exercée [cm²]</translation>
    </message>
    <message>
        <source>Pressed hard enough [%]</source>
        <translation>Assez appuyé [%]</translation>
    </message>
    <message>
        <source>Largest recorded change [%]</source>
        <translation>Plus grand changement enregistré [%]</translation>
    </message>
    <message>
        <source>Findings by layer</source>
        <translation>Points repérés par couche</translation>
    </message>
    <message>
        <source>95th percentile: the force stayed below this value for 95 % of the contact time. Research measures, not a diagnosis.</source>
        <translation>95ᵉ centile&#x202f;: la force est restée sous cette valeur pendant 95 % du temps de contact. Mesures de recherche, pas un diagnostic.</translation>
    </message>
    <message>
        <source>%1 % of the surface of %2</source>
        <translation>%1 % de la surface de %2</translation>
    </message>
    <message>
        <source>The hand was in contact for %1, with a peak force of %2 N.</source>
        <translation>La main a été en contact pendant %1, avec une force maximale de %2 N.</translation>
    </message>
    <message>
        <source>Examined: %1, with a peak force of %2 N.</source>
        <translation>Examiné&#x202f;: %1, avec une force maximale de %2 N.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) were marked.</source>
        <translation>
            <numerusform>%n observation a été marquée.</numerusform>
            <numerusform>%n observations ont été marquées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 lumps, %2 are palpable by a trained hand; %3 of these were pressed hard enough to feel.</source>
        <translation>Sur %1 nodules, %2 sont palpables par une main exercée&#x202f;; %3 d’entre eux ont été pressés assez fort.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
</context>
<context>
    <name>SceneDocument</name>
    <message>
        <source>Mark %1</source>
        <translation>Marquer %1</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash. Save the scene. %1</source>
        <translation>Les modifications non enregistrées seraient perdues en cas de plantage. Enregistrez la scène. %1</translation>
    </message>
    <message>
        <source>Remove the image</source>
        <translation>Retirer l’image</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Afficher %1</translation>
    </message>
    <message>
        <source>Move the section</source>
        <translation>Déplacer la coupe</translation>
    </message>
    <message>
        <source>Show a section</source>
        <translation>Afficher une coupe</translation>
    </message>
    <message>
        <source>End the section</source>
        <translation>Terminer la coupe</translation>
    </message>
    <message>
        <source>Change the window of the image</source>
        <translation>Modifier la fenêtre de l’image</translation>
    </message>
</context>
<context>
    <name>palpate::Message</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1&#x202f;; %2</translation>
    </message>
    <message>
        <source>(%1 mm, %2 N)</source>
        <translation>(%1 mm, %2 N)</translation>
    </message>
    <message>
        <source>found %1, expected finite numbers</source>
        <translation>trouvé&#x202f;: %1, des nombres finis étaient attendus</translation>
    </message>
    <message>
        <source>found %1, expected the first point at 0 mm and 0 N</source>
        <translation>trouvé&#x202f;: %1, le premier point était attendu à 0 mm et 0 N</translation>
    </message>
    <message>
        <source>found %1, expected a force of at least 0 N</source>
        <translation>trouvé&#x202f;: %1, une force d’au moins 0 N était attendue</translation>
    </message>
    <message>
        <source>found %1, expected a depth of %2 to %3 mm</source>
        <translation>trouvé&#x202f;: %1, une profondeur de %2 à %3 mm était attendue</translation>
    </message>
    <message>
        <source>found %1, a slope of %2 N/mm from the previous point, expected at most %3 N/mm</source>
        <translation>trouvé&#x202f;: %1, une pente de %2 N/mm depuis le point précédent, au plus %3 N/mm étaient attendus</translation>
    </message>
    <message>
        <source>found more points, expected 2 to %1</source>
        <translation>trop de points trouvés, 2 à %1 étaient attendus</translation>
    </message>
    <message>
        <source>found %1 points, expected 2 to %2</source>
        <translation>%1 points trouvés, 2 à %2 étaient attendus</translation>
    </message>
    <message>
        <source>point %1 of %2: %3</source>
        <translation>point %1 sur %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3 to %4 %5</source>
        <translation>%1&#x202f;: trouvé&#x202f;: %2, attendu&#x202f;: de %3 à %4 %5</translation>
    </message>
    <message>
        <source>%1: found %2, expected at most %3 (%4)</source>
        <translation>%1&#x202f;: trouvé&#x202f;: %2, attendu&#x202f;: au plus %3 (%4)</translation>
    </message>
    <message>
        <source>the force falls by %1 N/mm, expected at most %2 N/mm</source>
        <translation>la force baisse de %1 N/mm, au plus %2 N/mm étaient attendus</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permission refusée</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Plus de place sur le disque</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Quota disque dépassé</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Fichier trop volumineux</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Est un dossier</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>N’est pas un dossier</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Le fichier existe déjà</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Erreur d’entrée/sortie</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nom de fichier trop long</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>n’est pas un fichier</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another folder</source>
        <translation>%1&#x202f;: écriture impossible&#x202f;: %2&#x202f;; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>hand script: found no target, expected at least one</source>
        <translation>script de main&#x202f;: aucune cible trouvée, au moins une était attendue</translation>
    </message>
    <message>
        <source>hand script: target %1 is not finite</source>
        <translation>script de main&#x202f;: la cible %1 n’est pas finie</translation>
    </message>
    <message>
        <source>hand script: found target %1 at %2 s, expected a time after %3 s</source>
        <translation>script de main&#x202f;: cible %1 trouvée à %2 s, un temps après %3 s était attendu</translation>
    </message>
    <message>
        <source>hand script: target %1 needs too high a speed</source>
        <translation>script de main&#x202f;: la cible %1 exige une vitesse trop élevée</translation>
    </message>
    <message>
        <source>the motion to play has no rows</source>
        <translation>le mouvement à rejouer n’a pas de lignes</translation>
    </message>
    <message>
        <source>%1 belongs to another user, expected you or root as its owner</source>
        <translation>%1 appartient à un autre utilisateur, vous ou root étiez attendus comme propriétaire</translation>
    </message>
    <message>
        <source>others may write to %1; remove this permission with: chmod go-w &apos;%1&apos;</source>
        <translation>d’autres peuvent écrire dans %1&#x202f;; retirez ce droit par chmod go-w &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1: skipped, %2</source>
        <translation>%1&#x202f;: ignoré, %2</translation>
    </message>
    <message>
        <source>not a Qt plugin</source>
        <translation>pas un greffon Qt</translation>
    </message>
    <message>
        <source>a plugin of another program: found &quot;%1&quot;, expected &quot;%2&quot;</source>
        <translation>un greffon d’un autre programme&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>built for device API %1, this program has %2; rebuild it against this version</source>
        <translation>construit pour l’API d’appareil %1, ce programme a %2&#x202f;; reconstruisez-le pour cette version</translation>
    </message>
    <message>
        <source>found apiVersion %1 in its metadata, expected %2, which it was built for; correct its plugin.json and rebuild it</source>
        <translation>apiVersion %1 trouvée dans ses métadonnées, %2 était attendue, pour laquelle il est construit&#x202f;; corrigez plugin.json et reconstruisez-le</translation>
    </message>
    <message>
        <source>found the id &quot;%1&quot; in its metadata, expected lowercase letters, digits and dashes</source>
        <translation>identifiant «&#x202f;%1&#x202f;» trouvé dans ses métadonnées, des minuscules, chiffres et tirets étaient attendus</translation>
    </message>
    <message>
        <source>its id &quot;%1&quot; belongs to a built-in device</source>
        <translation>son identifiant «&#x202f;%1&#x202f;» est celui d’un appareil intégré</translation>
    </message>
    <message>
        <source>its metadata has no &quot;%1&quot;</source>
        <translation>ses métadonnées n’ont pas «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>%1: skipped, %2 has the same id and comes first</source>
        <translation>%1&#x202f;: ignoré, %2 a le même identifiant et vient d’abord</translation>
    </message>
    <message>
        <source>%1: its root object is not a device plugin</source>
        <translation>%1&#x202f;: son objet racine n’est pas un greffon d’appareil</translation>
    </message>
    <message>
        <source>%1: skipped, it hung when it was started</source>
        <translation>%1&#x202f;: ignoré, bloqué au démarrage</translation>
    </message>
    <message>
        <source>%1: could not be tried: %2: %3</source>
        <translation>%1&#x202f;: essai impossible&#x202f;: %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1: skipped, it crashed when it was started (signal %2)</source>
        <translation>%1&#x202f;: ignoré, plantage au démarrage (signal %2)</translation>
    </message>
    <message>
        <source>%1: skipped, it ended the process when it was started</source>
        <translation>%1&#x202f;: ignoré, a mis fin au processus au démarrage</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started: %2</source>
        <translation>%1&#x202f;: ignoré, échec au démarrage&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started</source>
        <translation>%1&#x202f;: ignoré, échec au démarrage</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at least %3</source>
        <translation>main simulée&#x202f;: %1&#x202f;: trouvé %2, attendu au moins %3</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at most %3</source>
        <translation>main simulée&#x202f;: %1&#x202f;: trouvé %2, attendu au plus %3</translation>
    </message>
    <message>
        <source>found a mesh of %1 mm from its centre to its side, expected at most %2 mm</source>
        <translation>maillage de %1 mm du centre au côté trouvé, au plus %2 mm étaient attendus</translation>
    </message>
    <message>
        <source>is not deeper than the previous knot</source>
        <translation>n’est pas plus profond que le précédent</translation>
    </message>
    <message>
        <source>has a steeper slope than any law</source>
        <translation>a une pente plus forte que toute loi</translation>
    </message>
    <message>
        <source>follows a cell with a force below 0</source>
        <translation>suit une cellule dont la force est inférieure à 0</translation>
    </message>
    <message>
        <source>has a number that is not finite</source>
        <translation>contient un nombre non fini</translation>
    </message>
    <message>
        <source>is not at 0 mm and 0 N</source>
        <translation>n’est pas à 0 mm et 0 N</translation>
    </message>
    <message>
        <source>has a force below 0</source>
        <translation>a une force inférieure à 0</translation>
    </message>
    <message>
        <source>ends with a slope below 0 or steeper than any law</source>
        <translation>finit par une pente inférieure à 0 ou plus forte que toute loi</translation>
    </message>
    <message>
        <source>force table: found %1 knots, expected 1 to %2</source>
        <translation>table de force&#x202f;: %1 nœuds trouvés, 1 à %2 étaient attendus</translation>
    </message>
    <message>
        <source>force table: knot %1 of %2 %3</source>
        <translation>table de force&#x202f;: le nœud %1 sur %2 %3</translation>
    </message>
    <message>
        <source>force table: found %1 bytes, expected %2 for each knot</source>
        <translation>table de force&#x202f;: %1 octets trouvés, %2 par nœud étaient attendus</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a recording</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un maillage, une scène ou un enregistrement</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height, as 1280x800</source>
        <translation>--size&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu largeur x hauteur, comme 1280x800</translation>
    </message>
    <message>
        <source>%1: found nothing palpable, expected a surface to touch</source>
        <translation>%1&#x202f;: rien de palpable trouvé, une surface à toucher était attendue</translation>
    </message>
    <message>
        <source>%1: %2; expected a recording as it was written, or what session recover makes of it</source>
        <translation>%1&#x202f;: %2&#x202f;; attendu un enregistrement tel qu’il a été écrit, ou sa copie par session recover</translation>
    </message>
    <message>
        <source>evaluate: found no SCENE and no bundled phantom, expected a mesh or a scene file</source>
        <translation>evaluate&#x202f;: ni SCENE ni fantôme fourni trouvés, attendu un maillage ou un fichier de scène</translation>
    </message>
    <message>
        <source>--out: %1 cannot be made: %2</source>
        <translation>--out&#x202f;: %1 ne peut pas être créé&#x202f;: %2</translation>
    </message>
    <message>
        <source>--felt: found %1, expected no SCENE</source>
        <translation>--felt&#x202f;: trouvé %1, aucune SCENE n’était attendue</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a whole number from %2 to %3</source>
        <translation>trouvé «&#x202f;%1&#x202f;», attendu un entier de %2 à %3</translation>
    </message>
    <message>
        <source>--ratio: found &quot;%1&quot;, expected NAME=R, as &quot;lump 12 mm=4.4&quot;</source>
        <translation>--ratio&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu NAME=R, comme «&#x202f;lump 12 mm=4.4&#x202f;»</translation>
    </message>
    <message>
        <source>--ratio: found %1 twice, expected once</source>
        <translation>--ratio&#x202f;: %1 trouvé deux fois, attendu une fois</translation>
    </message>
    <message>
        <source>%1: found neither a scene nor a recording, expected a file that keeps findings (.palpate.json or .palpate)</source>
        <translation>%1&#x202f;: ni une scène ni un enregistrement, attendu un fichier qui contient des points repérés (.palpate.json ou .palpate)</translation>
    </message>
    <message>
        <source>stdout: the findings could not be written</source>
        <translation>stdout&#x202f;: les points repérés n’ont pas pu être écrits</translation>
    </message>
    <message>
        <source>findings --import: found %1, expected a scene (.palpate.json)</source>
        <translation>findings --import&#x202f;: trouvé %1, attendu une scène (.palpate.json)</translation>
    </message>
    <message>
        <source>findings: found one of --import and --out, expected both: the scene with what is taken is another file</source>
        <translation>findings&#x202f;: une seule des options --import et --out trouvée, les deux étaient attendues&#x202f;: la scène avec les points repris est un autre fichier</translation>
    </message>
    <message>
        <source>findings: found - for --csv and --markups, expected it for one</source>
        <translation>findings&#x202f;: - trouvé pour --csv et --markups, attendu pour une seule</translation>
    </message>
    <message>
        <source>findings --import: found --csv or --markups too, expected --out alone: export from there</source>
        <translation>findings --import&#x202f;: --csv ou --markups aussi trouvé, attendu --out seul&#x202f;; exportez depuis la nouvelle scène</translation>
    </message>
    <message>
        <source>%1: %2, expected the program that does `palpate %3`: install it beside palpate, or build all of Palpate</source>
        <translation>%1&#x202f;: %2, attendu le programme de `palpate %3`&#x202f;: installez-le à côté de palpate, ou construisez tout Palpate</translation>
    </message>
    <message>
        <source>%1: found after an option, expected as the first word after palpate</source>
        <translation>%1&#x202f;: trouvé après une option, attendu comme premier mot après palpate</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a folder</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un maillage, une scène ou un dossier</translation>
    </message>
    <message>
        <source>%1: found a recording, expected a mesh (palpate session info reads recordings)</source>
        <translation>%1&#x202f;: enregistrement trouvé, attendu un maillage (palpate session info lit les enregistrements)</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a folder of meshes</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un maillage, une scène ou un dossier de maillages</translation>
    </message>
    <message>
        <source>%1: no such file, expected a motion CSV or a recording</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un mouvement en CSV ou un enregistrement</translation>
    </message>
    <message>
        <source>%1: cannot be written: not a file; a recording is one, expected its name</source>
        <translation>%1&#x202f;: écriture impossible&#x202f;: n’est pas un fichier&#x202f;; attendu le nom d’un fichier pour l’enregistrement</translation>
    </message>
    <message>
        <source>%1: found a file of this name, expected a new one for the recording, or --force to replace it</source>
        <translation>%1&#x202f;: un fichier de ce nom existe, attendu un nouveau nom pour l’enregistrement, ou --force pour le remplacer</translation>
    </message>
    <message>
        <source>%1: found nothing palpable, expected a structure that is</source>
        <translation>%1&#x202f;: rien de palpable trouvé, attendu une structure palpable</translation>
    </message>
    <message>
        <source>%1: %2: this version does not know this field; it is kept, but not used</source>
        <translation>%1&#x202f;: %2&#x202f;: ce champ est inconnu de cette version&#x202f;; il est conservé, mais pas utilisé</translation>
    </message>
    <message>
        <source>%1: structure &quot;%2&quot; was touched by itself in the recording (layer %3), here it is felt through the structure around it; expected the scene that was recorded, or --force to replay the motion alone</source>
        <translation>%1&#x202f;: la structure «&#x202f;%2&#x202f;» a été touchée elle-même dans l’enregistrement (couche %3), ici elle se sent à travers la structure qui l’entoure&#x202f;; attendu la scène enregistrée, ou --force pour rejouer le mouvement seul</translation>
    </message>
    <message>
        <source>%1: structure &quot;%2&quot; was touched by itself in the recording (layer %3), here it is not palpable; expected the scene that was recorded, or --force to replay the motion alone</source>
        <translation>%1&#x202f;: la structure «&#x202f;%2&#x202f;» a été touchée elle-même dans l’enregistrement (couche %3), ici elle n’est pas palpable&#x202f;; attendu la scène enregistrée, ou --force pour rejouer le mouvement seul</translation>
    </message>
    <message>
        <source>%1: %2; expected the scene that was recorded, or --force</source>
        <translation>%1&#x202f;: %2&#x202f;; attendu la scène enregistrée, ou --force</translation>
    </message>
    <message>
        <source>%1: %2 ticks skipped: ticks before them are missing in the recording</source>
        <translation>%1&#x202f;: %2 instants ignorés&#x202f;: des instants qui les précèdent manquent dans l’enregistrement</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ticks were lost</source>
        <translation>%1&#x202f;: %2 instants sur %3 ont été perdus</translation>
    </message>
    <message>
        <source>the safety gate took the force away: %1</source>
        <translation>la sécurité a coupé la force&#x202f;: %1</translation>
    </message>
    <message>
        <source>not computed again: %1; say where the scene is with --scene</source>
        <translation>non recalculé&#x202f;: %1&#x202f;; indiquez où est la scène par --scene</translation>
    </message>
    <message>
        <source>%1: %2 ticks are missing and %3 after them could not be computed again</source>
        <translation>%1&#x202f;: %2 instants manquent et %3 qui les suivent n’ont pas pu être recalculés</translation>
    </message>
    <message>
        <source>%1: found a file that is no recording, expected another name for the copy, or --force to replace it</source>
        <translation>%1&#x202f;: un fichier qui n’est pas un enregistrement, attendu un autre nom pour la copie, ou --force pour le remplacer</translation>
    </message>
    <message>
        <source>%1: no coverage of %2: %3; say where the scene is with --scene</source>
        <translation>%1&#x202f;: pas de couverture de %2&#x202f;: %3&#x202f;; indiquez où est la scène par --scene</translation>
    </message>
    <message>
        <source>its surface is another one now</source>
        <translation>sa surface est maintenant une autre</translation>
    </message>
    <message>
        <source>session export: found no output, expected --csv or --vtp</source>
        <translation>session export&#x202f;: aucune sortie trouvée, attendu --csv ou --vtp</translation>
    </message>
    <message>
        <source>--device: found &quot;%1&quot;, expected one of %2</source>
        <translation>--device&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu l’un de %2</translation>
    </message>
    <message>
        <source>%1: found nothing to press, expected a palpable surface</source>
        <translation>%1&#x202f;: rien à presser trouvé, attendu une surface palpable</translation>
    </message>
    <message>
        <source>%1: a hand on %2 slips off it wherever it presses; is it the size it should be (--unit)?</source>
        <translation>%1&#x202f;: une main avec %2 en glisse partout où elle presse&#x202f;; sa taille est-elle juste (--unit)&#x202f;?</translation>
    </message>
    <message>
        <source>%1: DAMAGED, or changed after it was recorded, in 1 place: ticks that do not match their checksum were left out, and figures are those of the rest</source>
        <translation>%1&#x202f;: ENDOMMAGÉ, ou changé après l’enregistrement, à 1 endroit&#x202f;: les instants qui ne correspondent pas à leur somme de contrôle sont omis, et les chiffres sont ceux du reste</translation>
    </message>
    <message>
        <source>%1: DAMAGED, or changed after it was recorded, in %2 places: ticks that do not match their checksum were left out, and figures are those of the rest</source>
        <translation>%1&#x202f;: ENDOMMAGÉ, ou changé après l’enregistrement, à %2 endroits&#x202f;: les instants qui ne correspondent pas à leur somme de contrôle sont omis, et les chiffres sont ceux du reste</translation>
    </message>
    <message>
        <source>%1: and %2 more</source>
        <translation>%1&#x202f;: et %2 de plus</translation>
    </message>
    <message>
        <source>%1: %2; recorded by this build (%3)</source>
        <translation>%1&#x202f;: %2&#x202f;; enregistré par cette version (%3)</translation>
    </message>
    <message>
        <source>%1: %2; recorded by another build (%3), this one is %4</source>
        <translation>%1&#x202f;: %2&#x202f;; enregistré par une autre version (%3), celle-ci est %4</translation>
    </message>
    <message>
        <source>%1: %2; recorded by this build (%3), which should give the same bits</source>
        <translation>%1&#x202f;: %2&#x202f;; enregistré par cette version (%3), qui devrait donner les mêmes bits</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1&#x202f;: ne peut pas être écrit</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number above %3</source>
        <translation>%1&#x202f;: trouvé «&#x202f;%2&#x202f;», attendu un nombre supérieur à %3</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number of at least %3</source>
        <translation>%1&#x202f;: trouvé «&#x202f;%2&#x202f;», attendu un nombre d’au moins %3</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number above %3 and at most %4</source>
        <translation>%1&#x202f;: trouvé «&#x202f;%2&#x202f;», attendu un nombre supérieur à %3 et d’au plus %4</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number of at least %3 and at most %4</source>
        <translation>%1&#x202f;: trouvé «&#x202f;%2&#x202f;», attendu un nombre d’au moins %3 et d’au plus %4</translation>
    </message>
    <message>
        <source>--unit: found &quot;%1&quot;, expected m, cm or mm</source>
        <translation>--unit&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu m, cm ou mm</translation>
    </message>
    <message>
        <source>--frame: found &quot;%1&quot;, expected LPS, RAS or Y-up</source>
        <translation>--frame&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu LPS, RAS ou Y-up</translation>
    </message>
    <message>
        <source>%1: found it as input and output, expected another name for the output</source>
        <translation>%1&#x202f;: trouvé comme entrée et sortie, attendu un autre nom pour la sortie</translation>
    </message>
    <message>
        <source>%1: found it as output and a file of %2, expected another name for the output</source>
        <translation>%1&#x202f;: trouvé comme sortie et fichier de %2, attendu un autre nom pour la sortie</translation>
    </message>
    <message>
        <source>%1: found it as two outputs, expected a name for each</source>
        <translation>%1&#x202f;: trouvé pour deux sorties, attendu un nom pour chacune</translation>
    </message>
    <message>
        <source>--plugin-path: %1: expected a folder</source>
        <translation>--plugin-path&#x202f;: %1&#x202f;: un dossier était attendu</translation>
    </message>
    <message>
        <source>--layers: found &quot;%1&quot;, expected auto</source>
        <translation>--layers&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu auto</translation>
    </message>
    <message>
        <source>%1; meshes are read in this process</source>
        <translation>%1&#x202f;; les maillages sont lus dans ce processus</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>stopped by an unknown error</source>
        <translation>arrêté par une erreur inconnue</translation>
    </message>
    <message>
        <source>the output could not be written</source>
        <translation>la sortie n’a pas pu être écrite</translation>
    </message>
    <message>
        <source>%1 (palpate --help lists what there is)</source>
        <translation>%1 (palpate --help montre toutes les possibilités)</translation>
    </message>
    <message>
        <source>no picture after %1 s</source>
        <translation>aucune image après %1 s</translation>
    </message>
    <message>
        <source>%1: found a link, pipe or other special file, expected a file of settings; they are not kept. Remove it</source>
        <translation>%1&#x202f;: un lien, un tube ou un autre fichier spécial, attendu un fichier de réglages&#x202f;; ils ne sont pas gardés. Supprimez ce fichier</translation>
    </message>
    <message>
        <source>found no display (DISPLAY is not set), expected one for the window; app/run.sh draws without</source>
        <translation>aucun écran trouvé (DISPLAY n’est pas défini), la fenêtre en demande un&#x202f;; app/run.sh dessine sans écran</translation>
    </message>
    <message>
        <source>the display (%1) has no OpenGL, expected one that has; app/run.sh draws without a display</source>
        <translation>l’écran (%1) n’a pas OpenGL, attendu un écran qui l’a&#x202f;; app/run.sh dessine sans écran</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>force per millimetre of depth</source>
        <translation>force par millimètre de profondeur</translation>
    </message>
    <message>
        <source>newton per millimetre</source>
        <translation>newtons par millimètre</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>resisting force per mm/s of movement</source>
        <translation>force résistante par mm/s de mouvement</translation>
    </message>
    <message>
        <source>newton seconds per millimetre</source>
        <translation>newtons-secondes par millimètre</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Frottement statique</translation>
    </message>
    <message>
        <source>tangential force that starts sliding, as a fraction of the normal force</source>
        <translation>force tangentielle qui déclenche le glissement, en fraction de la force normale</translation>
    </message>
    <message>
        <source>Sliding friction</source>
        <translation>Frottement de glissement</translation>
    </message>
    <message>
        <source>tangential force while sliding, as a fraction of the normal force</source>
        <translation>force tangentielle pendant le glissement, en fraction de la force normale</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Freinage</translation>
    </message>
    <message>
        <source>resisting force per mm/s of sliding</source>
        <translation>force résistante par mm/s de glissement</translation>
    </message>
    <message>
        <source>Initial stiffness</source>
        <translation>Raideur initiale</translation>
    </message>
    <message>
        <source>Growth with depth</source>
        <translation>Hausse en profondeur</translation>
    </message>
    <message>
        <source>Maximum stiffness</source>
        <translation>Raideur maximale</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module d’Young</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Rayon de la boule</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>Épaisseur de la couche</translation>
    </message>
    <message>
        <source>Bonded to the layer below</source>
        <translation>Liée à la couche du dessous</translation>
    </message>
    <message>
        <source>Stiffness before the click</source>
        <translation>Raideur avant le déclic</translation>
    </message>
    <message>
        <source>Force at the click</source>
        <translation>Force au déclic</translation>
    </message>
    <message>
        <source>Force after the click</source>
        <translation>Force après le déclic</translation>
    </message>
    <message>
        <source>Depth of the force drop</source>
        <translation>Profondeur de la chute de force</translation>
    </message>
    <message>
        <source>Stiffness after the click</source>
        <translation>Raideur après le déclic</translation>
    </message>
    <message>
        <source>This device needs no calibration.</source>
        <translation>Cet appareil ne demande pas de calibrage.</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2</source>
        <translation>%1&#x202f;: ne peut pas être créé&#x202f;: %2</translation>
    </message>
    <message>
        <source>The device gave a position that is not a number. Check its driver, then re-arm.</source>
        <translation>L’appareil a donné une position qui n’est pas un nombre. Vérifier son pilote, puis réarmer.</translation>
    </message>
    <message>
        <source>The device gave positions outside its workspace. Calibrate it, then re-arm.</source>
        <translation>L’appareil a donné des positions hors de son espace de travail. Le calibrer, puis réarmer.</translation>
    </message>
    <message>
        <source>The device&apos;s position jumped farther than a hand can move. Check its cable and calibration, then re-arm.</source>
        <translation>La position de l’appareil a sauté plus loin qu’une main ne peut aller. Vérifier câble et calibrage, puis réarmer.</translation>
    </message>
    <message>
        <source>The device stopped giving new positions. Check its connection, then re-arm.</source>
        <translation>L’appareil ne donne plus de nouvelles positions. Vérifier sa connexion, puis réarmer.</translation>
    </message>
    <message>
        <source>The device no longer answers. Plug it in again, then re-arm.</source>
        <translation>L’appareil ne répond plus. Le rebrancher, puis réarmer.</translation>
    </message>
    <message>
        <source>The model gave a force that is not a number. Leave the surface, then re-arm.</source>
        <translation>Le modèle a donné une force qui n’est pas un nombre. Quitter la surface, puis réarmer.</translation>
    </message>
    <message>
        <source>The computer could not keep the servo rate. Close other programs or lower the rate, then re-arm.</source>
        <translation>L’ordinateur n’a pas pu tenir la fréquence. Fermer d’autres programmes ou baisser la fréquence, puis réarmer.</translation>
    </message>
    <message>
        <source>The servo thread ended by an error. Start the device again.</source>
        <translation>La boucle d’asservissement a fini par une erreur. Redémarrer l’appareil.</translation>
    </message>
    <message>
        <source>real-time priority</source>
        <translation>priorité temps réel</translation>
    </message>
    <message>
        <source>locked memory</source>
        <translation>mémoire verrouillée</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1</source>
        <translation>SCHED_FIFO %1</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1 was refused: %2</source>
        <translation>SCHED_FIFO %1 a été refusé&#x202f;: %2</translation>
    </message>
    <message>
        <source>mlockall was refused: %1</source>
        <translation>mlockall a été refusé&#x202f;: %1</translation>
    </message>
    <message>
        <source>only %1 KiB may be locked: %2</source>
        <translation>seuls %1 KiB peuvent être verrouillés&#x202f;: %2</translation>
    </message>
    <message>
        <source>pages stay in memory once touched</source>
        <translation>les pages restent en mémoire une fois utilisées</translation>
    </message>
    <message>
        <source>CPU %1: the program may not run on it (see taskset -p, or the container&apos;s settings), expected one of %2</source>
        <translation>CPU %1&#x202f;: le programme ne peut pas y tourner (voir taskset -p, ou les réglages du conteneur), attendu l’un de %2</translation>
    </message>
    <message>
        <source>CPU %1: this machine has no such CPU, expected one of %2</source>
        <translation>CPU %1&#x202f;: cette machine n’a pas ce CPU, attendu l’un de %2</translation>
    </message>
    <message>
        <source>thread name</source>
        <translation>nom du fil d’exécution</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>«&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>non demandé</translation>
    </message>
    <message>
        <source>timer slack</source>
        <translation>tolérance du minuteur</translation>
    </message>
    <message>
        <source>%1 ns</source>
        <translation>%1 ns</translation>
    </message>
    <message>
        <source>own CPU</source>
        <translation>CPU réservé</translation>
    </message>
    <message>
        <source>CPU %1</source>
        <translation>CPU %1</translation>
    </message>
    <message>
        <source>CPU %1 was refused: %2</source>
        <translation>le CPU %1 a été refusé&#x202f;: %2</translation>
    </message>
    <message>
        <source>floating point</source>
        <translation>virgule flottante</translation>
    </message>
    <message>
        <source>default environment, denormals kept: a replay gives the same bits</source>
        <translation>environnement par défaut, nombres dénormalisés gardés&#x202f;: une relecture donne les mêmes bits</translation>
    </message>
    <message>
        <source>the default environment could not be set</source>
        <translation>l’environnement par défaut n’a pas pu être rétabli</translation>
    </message>
    <message>
        <source>servo rate is %1 Hz, expected 1 to 10000</source>
        <translation>la fréquence est de %1 Hz, attendu de 1 à 10000</translation>
    </message>
    <message>
        <source>the servo ring holds %1 ticks, expected 2 to %2</source>
        <translation>le tampon circulaire contient %1 instants, attendu de 2 à %2</translation>
    </message>
    <message>
        <source>the servo loop is already running</source>
        <translation>la boucle d’asservissement tourne déjà</translation>
    </message>
    <message>
        <source>the device could not be started: %1</source>
        <translation>l’appareil n’a pas pu démarrer&#x202f;: %1</translation>
    </message>
    <message>
        <source>the device could not be started: its driver failed</source>
        <translation>l’appareil n’a pas pu démarrer&#x202f;: son pilote a échoué</translation>
    </message>
    <message>
        <source>the servo loop is not running</source>
        <translation>la boucle d’asservissement ne tourne pas</translation>
    </message>
    <message>
        <source>the device or the servo thread could not be started: %1</source>
        <translation>l’appareil ou la boucle d’asservissement n’a pas pu démarrer&#x202f;: %1</translation>
    </message>
    <message>
        <source>the servo thread could not be set up</source>
        <translation>la boucle d’asservissement n’a pas pu être préparée</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>le fichier n’est pas une base de données</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>l’image disque de la base est mal formée</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>impossible d’ouvrir le fichier de la base</translation>
    </message>
    <message>
        <source>database or disk is full</source>
        <translation>la base ou le disque est plein</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>tentative d’écriture dans une base en lecture seule</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>erreur d’entrée-sortie du disque</translation>
    </message>
    <message>
        <source>%1: found a database with a write-ahead log, expected one with a rollback journal, as Palpate writes it: another program changed it</source>
        <translation>%1&#x202f;: une base à journal anticipé (WAL), une base à journal de retour était attendue, comme Palpate l’écrit&#x202f;: un autre programme l’a modifiée</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>its pages lead to more rows than a file of its size holds</source>
        <translation>ses pages mènent à plus de lignes qu’un fichier de cette taille n’en contient</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1&#x202f;: ne peut pas être lu&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1&#x202f;: ne peut pas être écrit&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: found something else than a file, expected the journal of a recording; nothing was opened. Move it away to read the recording as it is</source>
        <translation>%1&#x202f;: autre chose qu’un fichier, le journal d’un enregistrement était attendu&#x202f;; rien n’a été ouvert. Déplacez-le pour lire l’enregistrement tel quel</translation>
    </message>
    <message>
        <source>%1: found the journal of several databases, which names another file to be deleted; Palpate writes none, so this was not made by Palpate; nothing was opened. Move it away to read the recording as it is</source>
        <translation>%1&#x202f;: le journal de plusieurs bases, qui nomme un autre fichier à supprimer&#x202f;; Palpate n’en écrit pas, il ne vient donc pas de Palpate&#x202f;; rien n’a été ouvert. Déplacez-le pour lire l’enregistrement tel quel</translation>
    </message>
    <message>
        <source>a temporary file</source>
        <translation>un fichier temporaire</translation>
    </message>
    <message>
        <source>it asks to open %1, expected nothing but the recording and its journal</source>
        <translation>il demande à ouvrir %1, rien que l’enregistrement et son journal n’était attendu</translation>
    </message>
    <message>
        <source>it asks to delete %1, expected nothing but the recording and its journal</source>
        <translation>il demande à supprimer %1, rien que l’enregistrement et son journal n’était attendu</translation>
    </message>
    <message>
        <source>its journal holds more than a recorder changes at a time</source>
        <translation>son journal contient plus qu’un enregistrement ne change à la fois</translation>
    </message>
    <message>
        <source>distance: found %1 mm, expected at least %2 mm for surfaces this large</source>
        <translation>distance&#x202f;: trouvé %1 mm, attendu au moins %2 mm pour des surfaces aussi grandes</translation>
    </message>
    <message>
        <source>measuring was cancelled</source>
        <translation>la mesure a été annulée</translation>
    </message>
    <message>
        <source>the disk cannot be written (%1)</source>
        <translation>le disque ne peut pas être écrit (%1)</translation>
    </message>
    <message>
        <source>%1: the recording ended at %2 s because %3; what was felt after is not in it</source>
        <translation>%1&#x202f;: l’enregistrement a fini à %2 s car %3&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>%1: nothing was recorded because %2</source>
        <translation>%1&#x202f;: rien n’a été enregistré car %2</translation>
    </message>
    <message>
        <source>%1: recording ended: %2</source>
        <translation>%1&#x202f;: l’enregistrement a pris fin&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: is still being recorded</source>
        <translation>%1&#x202f;: est encore en cours d’enregistrement</translation>
    </message>
    <message>
        <source>%1: cannot be recorded: the servo loop is not running</source>
        <translation>%1&#x202f;: impossible d’enregistrer&#x202f;: la boucle d’asservissement ne tourne pas</translation>
    </message>
    <message>
        <source>%1: cannot be recorded: the servo loop does not answer</source>
        <translation>%1&#x202f;: impossible d’enregistrer&#x202f;: la boucle d’asservissement ne répond pas</translation>
    </message>
    <message>
        <source>%1: %2 ticks were lost</source>
        <translation>%1&#x202f;: %2 instants ont été perdus</translation>
    </message>
    <message>
        <source>%1: no such file, expected a recording</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un enregistrement</translation>
    </message>
    <message>
        <source>%1: cannot be opened: %2</source>
        <translation>%1&#x202f;: ne peut pas être ouvert&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: found no SQLite database, expected a recording</source>
        <translation>%1&#x202f;: trouvé autre chose qu’une base SQLite, attendu un enregistrement</translation>
    </message>
    <message>
        <source>%1: found no tick with a hand, expected at least one</source>
        <translation>%1&#x202f;: aucun instant avec une main, attendu au moins un</translation>
    </message>
    <message>
        <source>%1 (and %2 more places)</source>
        <translation>%1 (et %2 autres endroits)</translation>
    </message>
    <message>
        <source>%1: damaged: %2</source>
        <translation>%1&#x202f;: endommagé&#x202f;: %2</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>complet</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk was full; what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s car le disque était plein&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk could not be written; what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s car le disque ne pouvait pas être écrit&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>ended at %1 s without being closed (a crash, or a full disk); what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s sans être fermé (un arrêt brutal ou un disque plein)&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>tick %1 after tick %2: ticks must ascend</source>
        <translation>instant %1 après l’instant %2&#x202f;: les instants doivent être croissants</translation>
    </message>
    <message>
        <source>the disk takes no more: %1 ticks lost</source>
        <translation>le disque n’accepte plus rien&#x202f;: %1 instants perdus</translation>
    </message>
    <message>
        <source>scene %1 is described already</source>
        <translation>la scène %1 est déjà décrite</translation>
    </message>
    <message>
        <source>its first page is damaged</source>
        <translation>sa première page est endommagée</translation>
    </message>
    <message>
        <source>%1: is the recording itself, expected another name</source>
        <translation>%1&#x202f;: est l’enregistrement lui-même, attendu un autre nom</translation>
    </message>
    <message>
        <source>%1: cannot be written: not a file</source>
        <translation>%1&#x202f;: ne peut pas être écrit&#x202f;: n’est pas un fichier</translation>
    </message>
    <message>
        <source>found no SQLite database, expected a recording</source>
        <translation>trouvé autre chose qu’une base SQLite, attendu un enregistrement</translation>
    </message>
    <message>
        <source>%1: %2 rows were gathered from the file&apos;s %3 pages one by one</source>
        <translation>%1&#x202f;: %2 lignes ont été récupérées une à une dans les %3 pages du fichier</translation>
    </message>
    <message>
        <source>%1: %2: nothing can be recovered</source>
        <translation>%1&#x202f;: %2&#x202f;: rien ne peut être récupéré</translation>
    </message>
    <message>
        <source>metadata: %1 cannot be read; set to their defaults</source>
        <translation>métadonnées&#x202f;: %1 illisibles&#x202f;; remises à leurs valeurs par défaut</translation>
    </message>
    <message>
        <source>scene %1: left out</source>
        <translation>scène %1&#x202f;: omise</translation>
    </message>
    <message>
        <source>tick %1: found a time before the first tick&apos;s: left out</source>
        <translation>instant %1&#x202f;: un temps antérieur au premier&#x202f;: omis</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1&#x202f;: omis</translation>
    </message>
    <message>
        <source>the end: the recording was not closed; nothing is known after tick %1</source>
        <translation>la fin&#x202f;: l’enregistrement n’a pas été fermé&#x202f;; rien n’est connu après l’instant %1</translation>
    </message>
    <message>
        <source>scene generation %1 is not described in the recording</source>
        <translation>la scène %1 n’est pas décrite dans l’enregistrement</translation>
    </message>
    <message>
        <source>the state before the first tick: found contact with triangle %1 of structure %2, expected one of the scene&apos;s layer %3</source>
        <translation>l’état avant le premier instant&#x202f;: contact avec le triangle %1 de la structure %2 trouvé, attendu un triangle de la couche %3 de la scène</translation>
    </message>
    <message>
        <source>tick %1: god-object recorded at %2, now %3, %4 mm apart</source>
        <translation>instant %1&#x202f;: point de contact enregistré en %2, maintenant %3, écart de %4 mm</translation>
    </message>
    <message>
        <source>tick %1: force recorded as %2, now %3, %4 N apart</source>
        <translation>instant %1&#x202f;: force enregistrée %2, maintenant %3, écart de %4 N</translation>
    </message>
    <message>
        <source>tick %1: structure, triangle and constraints recorded as %2, now %3</source>
        <translation>instant %1&#x202f;: structure, triangle et contraintes enregistrés %2, maintenant %3</translation>
    </message>
    <message>
        <source>tick %1: layers (structure, triangle, friction) recorded as %2, now %3</source>
        <translation>instant %1&#x202f;: couches (structure, triangle, frottement) enregistrées %2, maintenant %3</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>a map of its tissue has %1 triangles, expected %2</source>
        <translation>une carte de son tissu a %1 triangles, %2 étaient attendus</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: law_table: %2</source>
        <translation>structure «&#x202f;%1&#x202f;» de l’enregistrement&#x202f;: law_table&#x202f;: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: its geometry (SHA-256 %2...) is not in the scene</source>
        <translation>structure «&#x202f;%1&#x202f;» de l’enregistrement&#x202f;: sa géométrie (SHA-256 %2...) n’est pas dans la scène</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: %2</source>
        <translation>structure «&#x202f;%1&#x202f;» de l’enregistrement&#x202f;: %2</translation>
    </message>
    <message>
        <source>found a fingertip radius of %1 mm in the recording, expected 0 to %2</source>
        <translation>un rayon du doigt de %1 mm dans l’enregistrement, attendu de 0 à %2</translation>
    </message>
    <message>
        <source>found %1, expected an ascending range from 0 to 2^53</source>
        <translation>trouvé&#x202f;: %1, attendu une plage croissante de 0 à 2^53</translation>
    </message>
    <message>
        <source>%1: found a checksum of %2 rows, expected at least one and at most one a tick</source>
        <translation>%1&#x202f;: une somme de contrôle sur %2 lignes, attendu au moins une et au plus une par instant</translation>
    </message>
    <message>
        <source>found %1 rows, expected %2</source>
        <translation>%1 lignes trouvées, %2 étaient attendues</translation>
    </message>
    <message>
        <source>%1: found rows without a checksum</source>
        <translation>%1&#x202f;: lignes sans somme de contrôle trouvées</translation>
    </message>
    <message>
        <source>%1: found without a checksum</source>
        <translation>%1&#x202f;: sans somme de contrôle</translation>
    </message>
    <message>
        <source>scene %1</source>
        <translation>scène %1</translation>
    </message>
    <message>
        <source>ticks %1 to %2</source>
        <translation>instants %1 à %2</translation>
    </message>
    <message>
        <source>checks: found line %1, expected %2: a part of the recording was taken out</source>
        <translation>sommes de contrôle&#x202f;: ligne %1 trouvée, %2 était attendue&#x202f;: une partie de l’enregistrement a été retirée</translation>
    </message>
    <message>
        <source>metadata</source>
        <translation>métadonnées</translation>
    </message>
    <message>
        <source>checks: found a line of kind &quot;%1&quot;, expected one of this version</source>
        <translation>sommes de contrôle&#x202f;: une ligne de sorte «&#x202f;%1&#x202f;», attendu une sorte de cette version</translation>
    </message>
    <message>
        <source>events %1 to %2</source>
        <translation>événements %1 à %2</translation>
    </message>
    <message>
        <source>%1: found a second checksum, expected one</source>
        <translation>%1&#x202f;: une deuxième somme de contrôle trouvée, une seule était attendue</translation>
    </message>
    <message>
        <source>checks: %1</source>
        <translation>sommes de contrôle&#x202f;: %1</translation>
    </message>
    <message>
        <source>checks: %1: found behind %2, expected ascending ranges</source>
        <translation>sommes de contrôle&#x202f;: %1&#x202f;: trouvé derrière %2, des plages croissantes étaient attendues</translation>
    </message>
    <message>
        <source>event %1</source>
        <translation>événement %1</translation>
    </message>
    <message>
        <source>tick %1: found a row without a checksum, expected ticks from 0</source>
        <translation>instant %1&#x202f;: une ligne sans somme de contrôle, des instants à partir de 0 étaient attendus</translation>
    </message>
    <message>
        <source>%1: found other bits than were written (checksum)</source>
        <translation>%1&#x202f;: d’autres bits que ceux écrits (somme de contrôle)</translation>
    </message>
    <message>
        <source>metadata or %1</source>
        <translation>métadonnées ou %1</translation>
    </message>
    <message>
        <source>found %1 there</source>
        <translation>trouvé là&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1&#x202f;: ne peut pas être lu</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another name</source>
        <translation>un fichier de ce nom existe&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the file %1 would be taken for a part of it; move that away or choose another name</source>
        <translation>le fichier %1 serait pris pour une partie de celui-ci&#x202f;; déplacez-le ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>another program is recording into it; choose another name</source>
        <translation>un autre programme y enregistre&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>another program wrote a file of this name meanwhile; kept as %1</source>
        <translation>un autre programme a écrit entre-temps un fichier de ce nom&#x202f;; gardé sous %1</translation>
    </message>
    <message>
        <source>found more than %1 %2, or more bytes of them than the file has, expected what a recorder writes</source>
        <translation>plus de %1 %2 trouvés, ou plus d’octets que le fichier n’en a, attendu ce qu’un enregistrement écrit</translation>
    </message>
    <message>
        <source>found another program&apos;s SQLite database, expected a Palpate recording</source>
        <translation>trouvé la base SQLite d’un autre programme, attendu un enregistrement de Palpate</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected 1 to %2: damaged</source>
        <translation>trouvé un enregistrement de version %1, attendu de 1 à %2&#x202f;: endommagé</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected at most %2: a newer Palpate made it</source>
        <translation>trouvé un enregistrement de version %1, attendu au plus %2&#x202f;: fait par un Palpate plus récent</translation>
    </message>
    <message>
        <source>values of the metadata</source>
        <translation>valeurs des métadonnées</translation>
    </message>
    <message>
        <source>found %1 for %2, expected %3 to %4</source>
        <translation>trouvé&#x202f;: %1 pour %2, attendu&#x202f;: de %3 à %4</translation>
    </message>
    <message>
        <source>found the layer %1, expected one from 0</source>
        <translation>couche %1 trouvée, attendu une couche à partir de 0</translation>
    </message>
    <message>
        <source>found no mesh with a unit, expected one of the recording&apos;s meshes</source>
        <translation>aucun maillage avec une unité trouvé, attendu l’un des maillages de l’enregistrement</translation>
    </message>
    <message>
        <source>found the scene %1, expected ascending generations of 32 bits</source>
        <translation>scène %1 trouvée, des numéros croissants de 32 bits étaient attendus</translation>
    </message>
    <message>
        <source>scene %1: %2</source>
        <translation>scène %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>scènes</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>structures</translation>
    </message>
    <message>
        <source>found the law %1, expected one of this version</source>
        <translation>loi %1 trouvée, attendu une loi de cette version</translation>
    </message>
    <message>
        <source>scene %1, structure &quot;%2&quot;: %3</source>
        <translation>scène %1, structure «&#x202f;%2&#x202f;»&#x202f;: %3</translation>
    </message>
    <message>
        <source>event %1: found values of another type or a tick out of range, expected a tick, a kind and its text: left out</source>
        <translation>événement %1&#x202f;: des valeurs d’un autre type ou un instant hors limites, attendu un instant, une sorte et son texte&#x202f;: omis</translation>
    </message>
    <message>
        <source>events</source>
        <translation>événements</translation>
    </message>
    <message>
        <source>lines of checks</source>
        <translation>lignes de sommes de contrôle</translation>
    </message>
    <message>
        <source>tick %1: found behind tick %2, expected ascending ticks: damaged</source>
        <translation>instant %1&#x202f;: trouvé derrière l’instant %2, des instants croissants étaient attendus&#x202f;: endommagé</translation>
    </message>
    <message>
        <source>tick %1: %2</source>
        <translation>instant %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>embedded surface %1...: is not in the recording</source>
        <translation>surface incluse %1...&#x202f;: n’est pas dans l’enregistrement</translation>
    </message>
    <message>
        <source>embedded surface %1...: found other bits than were written (checksum)</source>
        <translation>surface incluse %1...&#x202f;: d’autres bits que ceux écrits (somme de contrôle)</translation>
    </message>
    <message>
        <source>embedded surface %1...: found indices or coordinates out of range, expected triangles of three vertices within 10⁷ mm</source>
        <translation>surface incluse %1...&#x202f;: indices ou coordonnées hors limites, attendu des triangles de trois sommets à moins de 10⁷ mm</translation>
    </message>
    <message>
        <source>found more than %1 tables and views, expected the tables of a recording</source>
        <translation>plus de %1 tables et vues trouvées, attendu les tables d’un enregistrement</translation>
    </message>
    <message>
        <source>found &quot;%1&quot; for %2 &quot;%3&quot;, expected only the tables of version %4 and the view tick_values</source>
        <translation>«&#x202f;%1&#x202f;» trouvé pour %2 «&#x202f;%3&#x202f;», attendu seulement les tables de la version %4 et la vue tick_values</translation>
    </message>
    <message>
        <source>found no table &quot;%1&quot;, expected the tables of version %2</source>
        <translation>aucune table «&#x202f;%1&#x202f;» trouvée, attendu les tables de la version %2</translation>
    </message>
    <message>
        <source>found other columns in the table &quot;%1&quot;, expected those of version %2</source>
        <translation>d’autres colonnes trouvées dans la table «&#x202f;%1&#x202f;», attendu celles de la version %2</translation>
    </message>
    <message>
        <source>meta has no value &quot;%1&quot;</source>
        <translation>meta n’a pas de valeur «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is not a valid number, expected %2 to %3</source>
        <translation>la valeur «&#x202f;%1&#x202f;» de meta n’est pas un nombre valable, attendu de %2 à %3</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is not a whole number</source>
        <translation>la valeur «&#x202f;%1&#x202f;» de meta n’est pas un entier</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is %2, expected %3 to %4</source>
        <translation>la valeur «&#x202f;%1&#x202f;» de meta est %2, attendu de %3 à %4</translation>
    </message>
    <message>
        <source>meta value &quot;dt_s&quot; is not one period of &quot;rate_Hz&quot;</source>
        <translation>la valeur «&#x202f;dt_s&#x202f;» de meta n’est pas une période de «&#x202f;rate_Hz&#x202f;»</translation>
    </message>
    <message>
        <source>meta value &quot;start&quot; is not a state of this version</source>
        <translation>la valeur «&#x202f;start&#x202f;» de meta n’est pas un état de cette version</translation>
    </message>
    <message>
        <source>found more than %1 bytes without a line end, expected a CSV</source>
        <translation>plus de %1 octets sans fin de ligne trouvés, attendu un CSV</translation>
    </message>
    <message>
        <source>found no rows after the header, expected one a servo tick</source>
        <translation>aucune ligne après l’en-tête, attendu une par instant</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1&#x202f;: ligne %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1: line %2, column %3: %4</source>
        <translation>%1&#x202f;: ligne %2, colonne %3&#x202f;: %4</translation>
    </message>
    <message>
        <source>found 1 field, expected %1 as in the header</source>
        <translation>1 champ trouvé, attendu %1 comme dans l’en-tête</translation>
    </message>
    <message>
        <source>found %1 fields, expected %2 as in the header</source>
        <translation>%1 champs trouvés, attendu %2 comme dans l’en-tête</translation>
    </message>
    <message>
        <source>found an empty line, expected a header with x, y and z</source>
        <translation>une ligne vide trouvée, attendu un en-tête avec x, y et z</translation>
    </message>
    <message>
        <source>found the column twice, expected it once</source>
        <translation>colonne trouvée deux fois, attendue une fois</translation>
    </message>
    <message>
        <source>found no column %1 in %2, expected a header with x, y and z</source>
        <translation>aucune colonne %1 dans %2, attendu un en-tête avec x, y et z</translation>
    </message>
    <message>
        <source>found more than %1 rows, expected at most a day at 1 kHz: split the file</source>
        <translation>plus de %1 lignes trouvées, attendu au plus un jour à 1 kHz&#x202f;: divisez le fichier</translation>
    </message>
    <message>
        <source>found %1, expected a number</source>
        <translation>trouvé&#x202f;: %1, attendu un nombre</translation>
    </message>
    <message>
        <source>found %1, expected a finite number</source>
        <translation>trouvé&#x202f;: %1, attendu un nombre fini</translation>
    </message>
    <message>
        <source>found %1, expected a coordinate within 10⁹ mm</source>
        <translation>trouvé&#x202f;: %1, attendu une coordonnée à moins de 10⁹ mm</translation>
    </message>
    <message>
        <source>found a time before the previous row&apos;s, expected ascending times</source>
        <translation>un temps antérieur à celui de la ligne précédente, des temps croissants étaient attendus</translation>
    </message>
    <message>
        <source>found that no time passes, expected ascending times</source>
        <translation>aucun temps ne s’écoule, des temps croissants étaient attendus</translation>
    </message>
    <message>
        <source>found %1 s between rows on average, expected 0.00001 to 1 s: one row a servo tick</source>
        <translation>%1 s entre les lignes en moyenne, attendu de 0,00001 à 1 s&#x202f;: une ligne par instant</translation>
    </message>
    <message>
        <source>%1: no such file, expected a motion CSV</source>
        <translation>%1&#x202f;: fichier introuvable, attendu un mouvement en CSV</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2, expected a motion CSV</source>
        <translation>%1&#x202f;: ne peut pas être lu&#x202f;: %2, attendu un mouvement en CSV</translation>
    </message>
    <message>
        <source>%1: found a directory, expected a motion CSV</source>
        <translation>%1&#x202f;: un dossier, attendu un mouvement en CSV</translation>
    </message>
    <message>
        <source>a number within %1</source>
        <translation>un nombre d’au plus %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>un entier de %1 à %2</translation>
    </message>
    <message>
        <source>three numbers or none</source>
        <translation>trois nombres ou aucun</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>octets</translation>
    </message>
    <message>
        <source>found %1 for %2, expected %3</source>
        <translation>trouvé&#x202f;: %1 pour %2, attendu&#x202f;: %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
    <message>
        <source>found no contacts of layers in the column layers</source>
        <translation>aucun contact de couches dans la colonne layers</translation>
    </message>
    <message>
        <source>%1 is hidden or not palpable</source>
        <translation>%1 est masqué ou non palpable</translation>
    </message>
    <message>
        <source>the scene has no structure &quot;%1&quot;, which it names as the organ</source>
        <translation>la scène ne contient pas la structure «&#x202f;%1&#x202f;», nommée comme organe</translation>
    </message>
    <message>
        <source>it lies in no closed surface that can be felt</source>
        <translation>il ne se trouve dans aucune surface fermée palpable</translation>
    </message>
    <message>
        <source>its name is not that of a lump, and the scene gives no stiffness ratio</source>
        <translation>son nom n’est pas celui d’une masse, et la scène ne donne aucun rapport de rigidité</translation>
    </message>
    <message>
        <source>the scene names the organs of other lumps, but not of this one</source>
        <translation>la scène nomme les organes d’autres masses, mais pas de celle-ci</translation>
    </message>
    <message>
        <source>the SpaceMouse is the hand now; choose another device for it first</source>
        <translation>la SpaceMouse est la main&#x202f;; choisir d’abord un autre appareil pour celle-ci</translation>
    </message>
    <message>
        <source>the SpaceMouse moves the view or presses; switch that off first</source>
        <translation>la SpaceMouse déplace la vue ou appuie&#x202f;; désactivez d’abord cela</translation>
    </message>
    <message>
        <source>no device is called &quot;%1&quot;</source>
        <translation>aucun appareil ne s’appelle «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>the simulated hand palpates what is in the middle of the view: found nothing palpable there</source>
        <translation>la main simulée palpe ce qui est au milieu de la vue&#x202f;: rien de palpable trouvé là</translation>
    </message>
    <message>
        <source>found no open recording, expected one whose motion the device repeats</source>
        <translation>aucun enregistrement ouvert, attendu un dont l’appareil répète le mouvement</translation>
    </message>
    <message>
        <source>rate and CPU cannot be changed while a recording runs; stop it first</source>
        <translation>fréquence et CPU ne changent pas pendant un enregistrement&#x202f;; l’arrêter d’abord</translation>
    </message>
    <message>
        <source>the device cannot be changed while a recording runs; stop it first</source>
        <translation>l’appareil ne change pas pendant un enregistrement&#x202f;; l’arrêter d’abord</translation>
    </message>
    <message>
        <source>%1 may not be opened: install Palpate&apos;s udev rule (in lib/udev/rules.d) and plug the device in anew</source>
        <translation>%1 ne peut pas être ouvert&#x202f;: installez la règle udev de Palpate (dans lib/udev/rules.d) et rebranchez l’appareil</translation>
    </message>
    <message>
        <source>%1: could not be opened: %2</source>
        <translation>%1&#x202f;: n’a pas pu être ouvert&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: already started</source>
        <translation>%1&#x202f;: déjà démarré</translation>
    </message>
    <message>
        <source>%1: %2: found %3, expected %4 to %5</source>
        <translation>%1&#x202f;: %2&#x202f;: trouvé&#x202f;: %3, attendu&#x202f;: de %4 à %5</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>aucun nombre</translation>
    </message>
    <message>
        <source>no 6-axis mouse is connected: plug one in</source>
        <translation>aucune souris à 6 axes n’est connectée&#x202f;: branchez-en une</translation>
    </message>
    <message>
        <source>%1: at byte %2: %3, expected an object of numbers, {&quot;length_body_a&quot;: 0.080, ...}</source>
        <translation>%1&#x202f;: à l’octet %2&#x202f;: %3, attendu un objet de nombres, {&quot;length_body_a&quot;: 0.080, ...}</translation>
    </message>
    <message>
        <source>too large for a device&apos;s configuration</source>
        <translation>trop grand pour la configuration d’un appareil</translation>
    </message>
    <message>
        <source>%1: could not be read</source>
        <translation>%1&#x202f;: n’a pas pu être lu</translation>
    </message>
    <message>
        <source>no WoodenHaptics arm is connected (USB 1234:0006): plug it in and switch it on</source>
        <translation>aucun bras WoodenHaptics n’est connecté (USB 1234:0006)&#x202f;: branchez-le et allumez-le</translation>
    </message>
    <message>
        <source>woodenhaptics: %1: its reports have %2 bytes, expected 14 or 8: another device with mbed&apos;s ids</source>
        <translation>woodenhaptics&#x202f;: %1&#x202f;: ses rapports ont %2 octets, 14 ou 8 étaient attendus&#x202f;: un autre appareil avec les identifiants de mbed</translation>
    </message>
    <message>
        <source>woodenhaptics: %1: it does not answer; is it switched on?</source>
        <translation>woodenhaptics&#x202f;: %1&#x202f;: ne répond pas&#x202f;; est-il allumé&#x202f;?</translation>
    </message>
    <message>
        <source>ticks are missing</source>
        <translation>des ticks manquent</translation>
    </message>
    <message>
        <source>contact radius: found %1 mm, expected more than 0 and at most 30 mm</source>
        <translation>rayon de contact&#x202f;: trouvé %1 mm, attendu plus de 0 et au plus 30 mm</translation>
    </message>
    <message>
        <source>press depths: found %1, expected 1 to %2</source>
        <translation>profondeurs d’appui&#x202f;: trouvé %1, attendu 1 à %2</translation>
    </message>
    <message>
        <source>press depths: found %1 mm, expected 0 to 30 mm, ascending</source>
        <translation>profondeurs d’appui&#x202f;: trouvé %1 mm, attendu 0 à 30 mm, en ordre croissant</translation>
    </message>
    <message>
        <source>%1: contact radius: found %2 mm, expected at least %3 mm on a surface this large</source>
        <translation>%1&#x202f;: rayon de contact&#x202f;: trouvé %2 mm, attendu au moins %3 mm sur une surface aussi grande</translation>
    </message>
    <message>
        <source>%1: ratio: found %2, expected more than 0 and at most 10000</source>
        <translation>%1&#x202f;: rapport&#x202f;: trouvé %2, attendu plus de 0 et au plus 10000</translation>
    </message>
    <message>
        <source>%1: left out, its surface is open: it has no volume to be felt</source>
        <translation>%1&#x202f;: laissé de côté, sa surface est ouverte&#x202f;: il n’a pas de volume à sentir</translation>
    </message>
    <message>
        <source>%1: left out, its surface is inside out</source>
        <translation>%1&#x202f;: laissé de côté, sa surface est retournée</translation>
    </message>
    <message>
        <source>%1: left out, it lies outside %2</source>
        <translation>%1&#x202f;: laissé de côté, il est hors de %2</translation>
    </message>
    <message>
        <source>%1 and %2 reach into each other: where both are felt is not judged</source>
        <translation>%1 et %2 s’interpénètrent&#x202f;: là où les deux se sentent, rien n’est jugé</translation>
    </message>
    <message>
        <source>what can be felt was cancelled</source>
        <translation>le calcul de ce qui se sent a été annulé</translation>
    </message>
    <message>
        <source>%1: its surface is open or inside out; expected a closed one, or it can&apos;t be told what lies in it</source>
        <translation>%1&#x202f;: sa surface est ouverte ou retournée&#x202f;; attendu une surface fermée, sans quoi on ne peut savoir ce qu’elle contient</translation>
    </message>
    <message>
        <source>%1: found no lump in it that can be judged</source>
        <translation>%1&#x202f;: aucun nodule à l’intérieur qui puisse être jugé</translation>
    </message>
    <message>
        <source>%1: its triangles are wider than a finger&apos;s contact: what the hand feels of its lumps differs by up to %2 % from what is shown; a finer mesh mends it</source>
        <translation>%1&#x202f;: ses triangles sont plus larges que le contact d’un doigt&#x202f;: ce que la main sent de ses nodules diffère de %2&#xa0;% au plus de ce qui est montré&#x202f;; un maillage plus fin y remédie</translation>
    </message>
    <message>
        <source>%1: reading was cancelled</source>
        <translation>%1&#x202f;: la lecture a été annulée</translation>
    </message>
    <message>
        <source>no socket for the import server: %1</source>
        <translation>pas de socket pour le serveur d’importation&#x202f;: %1</translation>
    </message>
    <message>
        <source>no process for the import server: %1</source>
        <translation>pas de processus pour le serveur d’importation&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1: opening was cancelled</source>
        <translation>%1&#x202f;: l’ouverture a été annulée</translation>
    </message>
    <message>
        <source>%1: is not a Palpate scene: found neither `version` nor `structures`; expected a file that Palpate saved (.palpate.json)</source>
        <translation>%1&#x202f;: n’est pas une scène de Palpate&#x202f;: ni `version` ni `structures` trouvés&#x202f;; attendu un fichier enregistré par Palpate (.palpate.json)</translation>
    </message>
    <message>
        <source>%1: %2: found twice, expected it once</source>
        <translation>%1&#x202f;: %2&#x202f;: trouvé deux fois, attendu une seule</translation>
    </message>
    <message>
        <source>%1: version: found %2, expected at most %3: it was made by a newer Palpate</source>
        <translation>%1&#x202f;: version&#x202f;: trouvé %2, attendu au plus %3&#x202f;: elle vient d’un Palpate plus récent</translation>
    </message>
    <message>
        <source>VTK could not write it: %1</source>
        <translation>VTK n’a pas pu l’écrire&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1: not felt through an organ: %2</source>
        <translation>%1&#x202f;: non palpable à travers un organe&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out</source>
        <translation>%1 semble être dans %2, dont la surface est ouverte ou retournée</translation>
    </message>
    <message>
        <source>ratio of &quot;%1&quot;: found no such lump, expected a structure that lies in another one</source>
        <translation>rapport de «&#x202f;%1&#x202f;»&#x202f;: nodule introuvable, attendu une structure contenue dans une autre</translation>
    </message>
    <message>
        <source>found no lump, expected a palpable structure inside another one&apos;s closed surface, or one whose `inside` names its organ</source>
        <translation>aucun nodule trouvé, attendu une structure palpable dans la surface fermée d’une autre, ou une dont `inside` nomme l’organe</translation>
    </message>
    <message>
        <source>the servo thread does not answer</source>
        <translation>le fil servo ne répond pas</translation>
    </message>
    <message>
        <source>%1: found more than 64 MiB, expected a list of points</source>
        <translation>%1&#x202f;: plus de 64 MiB trouvés, attendu une liste de points</translation>
    </message>
    <message>
        <source>%1: byte %2: found %3, expected markups of 3D Slicer (.mrk.json)</source>
        <translation>%1&#x202f;: octet %2&#x202f;: trouvé %3, attendu des annotations 3D Slicer (.mrk.json)</translation>
    </message>
    <message>
        <source>no JSON object</source>
        <translation>aucun objet JSON</translation>
    </message>
    <message>
        <source>%1: markups: found nothing, expected lists of points: is this a .mrk.json of 3D Slicer?</source>
        <translation>%1&#x202f;: markups&#x202f;: rien trouvé, attendu des listes de points&#x202f;: est-ce un .mrk.json de 3D Slicer&#x202f;?</translation>
    </message>
    <message>
        <source>the recording does not say what scene it was made on</source>
        <translation>l’enregistrement ne dit pas sur quelle scène il a été fait</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1&#x202f;: fichier introuvable</translation>
    </message>
    <message>
        <source>%1: not written: cancelled</source>
        <translation>%1&#x202f;: non écrit&#x202f;: annulé</translation>
    </message>
    <message>
        <source>%1: not written: found no tick with a hand, expected at least one</source>
        <translation>%1&#x202f;: non écrit&#x202f;: aucun instant avec une main, attendu au moins un</translation>
    </message>
    <message>
        <source>%1: not written: no surface that is there was touched</source>
        <translation>%1&#x202f;: non écrit&#x202f;: aucune surface présente n’a été touchée</translation>
    </message>
    <message>
        <source>%1: the touched surface goes there; found another file, expected none or an older export. Choose another name</source>
        <translation>%1&#x202f;: la surface touchée va là&#x202f;; un autre fichier s’y trouve, aucun ou un export antérieur était attendu. Choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 is a recording and keeps its own layers</source>
        <translation>%1 est un enregistrement et garde ses propres couches</translation>
    </message>
    <message>
        <source>%1 is a scene file and keeps its own layers</source>
        <translation>%1 est un fichier de scène et garde ses propres couches</translation>
    </message>
    <message>
        <source>nothing lies in another structure: all is in one layer</source>
        <translation>rien n’est dans une autre structure&#x202f;: tout est dans une seule couche</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>the steps of %1 are felt, with forces that are wrong by a multiple: --smooth smooths them</source>
        <translation>les marches de %1 se sentent, avec des forces fausses d’un multiple&#x202f;: --smooth les lisse</translation>
    </message>
    <message>
        <source>1 surface is inside out and felt from within only: %1; --outwards turns closed surfaces outwards</source>
        <translation>1 surface est à l’envers et ne se sent que de l’intérieur&#x202f;: %1&#x202f;; --outwards tourne les surfaces fermées vers l’extérieur</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out and felt from within only: %2; --outwards turns closed surfaces outwards</source>
        <translation>%1 surfaces sont à l’envers et ne se sentent que de l’intérieur&#x202f;: %2&#x202f;; --outwards tourne les surfaces fermées vers l’extérieur</translation>
    </message>
    <message>
        <source>%1: found %2, expected 0 to %3 %4</source>
        <translation>%1&#x202f;: trouvé %2, attendu 0 à %3 %4</translation>
    </message>
    <message>
        <source>friction_dynamic: found %1, expected at most %2 (friction_static)</source>
        <translation>friction_dynamic&#x202f;: trouvé %1, attendu au plus %2 (friction_static)</translation>
    </message>
    <message>
        <source>1 value of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>1 valeur de tableau différait de plus de 10 % d’une autre au même sommet&#x202f;: la moyenne est prise</translation>
    </message>
    <message>
        <source>%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>%1 valeurs de tableaux différaient de plus de 10&#x202f;% d’une autre au même sommet&#x202f;: la moyenne est prise</translation>
    </message>
    <message>
        <source>1 triangle without area left out</source>
        <translation>1 triangle sans aire laissé de côté</translation>
    </message>
    <message>
        <source>%1 triangles without area left out</source>
        <translation>%1 triangles sans aire laissés de côté</translation>
    </message>
    <message>
        <source>1 duplicate triangle left out</source>
        <translation>1 triangle en double laissé de côté</translation>
    </message>
    <message>
        <source>%1 duplicate triangles left out</source>
        <translation>%1 triangles en double laissés de côté</translation>
    </message>
    <message>
        <source>1 triangle turned round to face the same way as the rest</source>
        <translation>1 triangle retourné pour regarder du même côté que les autres</translation>
    </message>
    <message>
        <source>%1 triangles turned round to face the same way as the rest</source>
        <translation>%1 triangles retournés pour regarder du même côté que les autres</translation>
    </message>
    <message>
        <source>1 open edge: the surface has holes or a rim</source>
        <translation>1 arête ouverte&#x202f;: la surface a des trous ou un bord</translation>
    </message>
    <message>
        <source>%1 open edges: the surface has holes or a rim</source>
        <translation>%1 arêtes ouvertes&#x202f;: la surface a des trous ou un bord</translation>
    </message>
    <message>
        <source>1 edge shared by more than two triangles</source>
        <translation>1 arête partagée par plus de deux triangles</translation>
    </message>
    <message>
        <source>%1 edges shared by more than two triangles</source>
        <translation>%1 arêtes partagées par plus de deux triangles</translation>
    </message>
    <message>
        <source>1 part without a consistent front</source>
        <translation>1 partie sans face avant cohérente</translation>
    </message>
    <message>
        <source>%1 parts without a consistent front</source>
        <translation>%1 parties sans face avant cohérente</translation>
    </message>
    <message>
        <source>1 part without an inside, touched from both sides</source>
        <translation>1 partie sans intérieur, touchée des deux côtés</translation>
    </message>
    <message>
        <source>%1 parts without an inside, touched from both sides</source>
        <translation>%1 parties sans intérieur, touchées des deux côtés</translation>
    </message>
    <message>
        <source>1 closed part looks inside out: touched from within only, unless turned outwards</source>
        <translation>1 partie fermée semble à l’envers&#x202f;: touchée de l’intérieur seulement, sauf si elle est retournée</translation>
    </message>
    <message>
        <source>%1 closed parts look inside out: touched from within only, unless turned outwards</source>
        <translation>%1 parties fermées semblent à l’envers&#x202f;: touchées de l’intérieur seulement, sauf si elles sont retournées</translation>
    </message>
    <message>
        <source>1 closed part was inside out and turned to face outwards</source>
        <translation>1 partie fermée était retournée et a été tournée vers l’extérieur</translation>
    </message>
    <message>
        <source>%1 closed parts were inside out and turned to face outwards</source>
        <translation>%1 parties fermées étaient retournées et ont été tournées vers l’extérieur</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, with its steps</source>
        <translation>surface d’une carte d’étiquettes à voxels de %1 × %2 × %3 mm, avec ses marches</translation>
    </message>
    <message>
        <source>staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)</source>
        <translation>escalier de voxels d’environ %1 × %2 × %3 mm (%4 % de l’aire dans %5 directions)</translation>
    </message>
    <message>
        <source>the mesh has no triangles, expected at least 1</source>
        <translation>le maillage n’a pas de triangles, attendu au moins 1</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices or triangles, expected at most %2</source>
        <translation>le maillage a %1 sommets ou triangles, attendu au plus %2</translation>
    </message>
    <message>
        <source>triangle %1 uses vertex %2, expected a number below %3</source>
        <translation>le triangle %1 utilise le sommet %2, attendu un numéro inférieur à %3</translation>
    </message>
    <message>
        <source>vertex %1 has the coordinate %2, expected a finite number</source>
        <translation>le sommet %1 a la coordonnée %2, attendu un nombre fini</translation>
    </message>
    <message>
        <source>vertex %1 has the coordinate %2 mm, expected at most %3 mm; check the unit</source>
        <translation>le sommet %1 a la coordonnée %2 mm, attendu au plus %3 mm&#x202f;; vérifiez l’unité</translation>
    </message>
    <message>
        <source>array %1 has %2 values, expected %3</source>
        <translation>le tableau %1 a %2 valeurs, attendu %3</translation>
    </message>
    <message>
        <source>weldWithin_mm: found %1, expected 0 to %2 mm</source>
        <translation>weldWithin_mm&#x202f;: trouvé %1, attendu 0 à %2 mm</translation>
    </message>
    <message>
        <source>none of the %1 triangles has an area; check the unit, expected mm</source>
        <translation>aucun des %1 triangles n’a d’aire&#x202f;; vérifiez l’unité, attendu mm</translation>
    </message>
    <message>
        <source>found structure %1, expected a number below %2</source>
        <translation>structure %1 trouvée, attendu un numéro inférieur à %2</translation>
    </message>
    <message>
        <source>structure %1 (%2)</source>
        <translation>structure %1 (%2)</translation>
    </message>
    <message>
        <source>fingertip: found a radius of %1, expected 0 to %2 mm</source>
        <translation>bout du doigt&#x202f;: rayon %1 trouvé, attendu 0 à %2 mm</translation>
    </message>
    <message>
        <source>structure %1 (%2): found no surface, expected at least one triangle</source>
        <translation>structure %1 (%2)&#x202f;: aucune surface trouvée, attendu au moins un triangle</translation>
    </message>
    <message>
        <source>found %1</source>
        <translation>trouvé %1</translation>
    </message>
    <message>
        <source>the keyword %1 or %2</source>
        <translation>le mot-clé %1 ou %2</translation>
    </message>
    <message>
        <source>found %1 as corner %2 of a facet</source>
        <translation>trouvé %1 comme coin %2 d’une facette</translation>
    </message>
    <message>
        <source>the keyword %1, three times in each facet</source>
        <translation>le mot-clé %1, trois fois dans chaque facette</translation>
    </message>
    <message>
        <source>the vertex has fewer than three coordinates</source>
        <translation>le sommet a moins de trois coordonnées</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>trois nombres</translation>
    </message>
    <message>
        <source>finite coordinates within 10 km</source>
        <translation>des coordonnées finies à moins de 10 km</translation>
    </message>
    <message>
        <source>found %1 after the third coordinate</source>
        <translation>trouvé %1 après la troisième coordonnée</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>la fin de la ligne</translation>
    </message>
    <message>
        <source>the keyword %1</source>
        <translation>le mot-clé %1</translation>
    </message>
    <message>
        <source>found %1 after three corners</source>
        <translation>trouvé %1 après trois coins</translation>
    </message>
    <message>
        <source>found a zero byte</source>
        <translation>trouvé un octet nul</translation>
    </message>
    <message>
        <source>the file ends after one complete triangle</source>
        <translation>le fichier finit après un triangle entier</translation>
    </message>
    <message>
        <source>the file ends after %1 complete triangles</source>
        <translation>le fichier finit après %1 triangles entiers</translation>
    </message>
    <message>
        <source>the rest of a facet, then the keyword %1</source>
        <translation>le reste d’une facette, puis le mot-clé %1</translation>
    </message>
    <message>
        <source>%1; --partial opens the complete triangles</source>
        <translation>%1&#x202f;; --partial ouvre les triangles complets</translation>
    </message>
    <message>
        <source>0 triangles</source>
        <translation>aucun triangle</translation>
    </message>
    <message>
        <source>at least one triangle</source>
        <translation>au moins un triangle</translation>
    </message>
    <message>
        <source>the last line, &quot;endsolid&quot;, is missing: if the file was cut off there, triangles are missing</source>
        <translation>la dernière ligne, «&#x202f;endsolid&#x202f;», manque&#x202f;: si le fichier a été coupé là, des triangles manquent</translation>
    </message>
    <message>
        <source>everything after the first triangle is lost</source>
        <translation>tout ce qui suit le premier triangle est perdu</translation>
    </message>
    <message>
        <source>everything after the first %1 triangles is lost</source>
        <translation>tout ce qui suit les %1 premiers triangles est perdu</translation>
    </message>
    <message>
        <source>a cell of VTK&apos;s type %1: not a surface, but a volume mesh or curved cells</source>
        <translation>une cellule de type VTK %1&#x202f;: non pas une surface, mais un maillage volumique ou des cellules courbes</translation>
    </message>
    <message>
        <source>number of corners of a cell of VTK&apos;s type %1: %2</source>
        <translation>nombre de sommets d’une cellule de type VTK %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>triangles and quadrilaterals: extract the surface first (ParaView: Extract Surface)</source>
        <translation>des triangles et des quadrilatères&#x202f;: extraire d’abord la surface (ParaView&#x202f;: Extract Surface)</translation>
    </message>
    <message>
        <source>vertices and lines left out: %1</source>
        <translation>points et lignes omis&#x202f;: %1</translation>
    </message>
    <message>
        <source>names and colours from the ITK-SNAP label description %1</source>
        <translation>noms et couleurs de la description d’étiquettes ITK-SNAP %1</translation>
    </message>
    <message>
        <source>the file has no names: names by the numbers of %1, check them</source>
        <translation>le fichier n’a pas de noms&#x202f;: noms selon les numéros de %1, à vérifier</translation>
    </message>
    <message>
        <source>structures of at most %1 voxels, whose shape is uncertain: %2</source>
        <translation>structures d’au plus %1 voxels, dont la forme est incertaine&#x202f;: %2</translation>
    </message>
    <message>
        <source>no voxels of %1</source>
        <translation>aucun voxel de %1</translation>
    </message>
    <message>
        <source>%1: found %2</source>
        <translation>%1&#x202f;: trouvé %2</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>un nombre entier à partir de 0</translation>
    </message>
    <message>
        <source>%1: declared %2</source>
        <translation>%1&#x202f;: annoncé %2</translation>
    </message>
    <message>
        <source>at most %1, one for each byte that follows</source>
        <translation>au plus %1, un pour chaque octet suivant</translation>
    </message>
    <message>
        <source>the line %1</source>
        <translation>la ligne %1</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>number of points</source>
        <translation>nombre de points</translation>
    </message>
    <message>
        <source>points of type %1</source>
        <translation>des points de type %1</translation>
    </message>
    <message>
        <source>a number type</source>
        <translation>un type numérique</translation>
    </message>
    <message>
        <source>a coordinate of point %1 of %2 is missing or not a number</source>
        <translation>une coordonnée du point %1 sur %2 manque ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>three numbers for each point</source>
        <translation>trois nombres pour chaque point</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>point %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: a point index is missing or not a whole number</source>
        <translation>%1&#x202f;: un indice de point manque ou n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>as many whole numbers as are declared</source>
        <translation>autant de nombres entiers qu’annoncé</translation>
    </message>
    <message>
        <source>%1 use point %2</source>
        <translation>%1 utilisent le point %2</translation>
    </message>
    <message>
        <source>%1 before this section</source>
        <translation>%1 avant cette section</translation>
    </message>
    <message>
        <source>no index, because there are no points</source>
        <translation>aucun indice, car il n’y a pas de points</translation>
    </message>
    <message>
        <source>%1: number of corners of cell %2: %3</source>
        <translation>%1&#x202f;: nombre de coins de la cellule %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1: the number of corners of cell %2 is missing</source>
        <translation>%1&#x202f;: le nombre de coins de la cellule %2 manque</translation>
    </message>
    <message>
        <source>%1 to %2, as many as the declared values allow</source>
        <translation>%1 à %2, autant que les valeurs annoncées le permettent</translation>
    </message>
    <message>
        <source>%1: number of values: declared %2</source>
        <translation>%1&#x202f;: nombre de valeurs&#x202f;: annoncé %2</translation>
    </message>
    <message>
        <source>%1, as many as the cells use</source>
        <translation>%1, autant que les cellules en utilisent</translation>
    </message>
    <message>
        <source>found %1 and %2</source>
        <translation>trouvé %1 et %2</translation>
    </message>
    <message>
        <source>the keyword %1 and an integer type</source>
        <translation>le mot-clé %1 et un type entier</translation>
    </message>
    <message>
        <source>%1: offset %2 is %3</source>
        <translation>%1&#x202f;: le décalage %2 est %3</translation>
    </message>
    <message>
        <source>%1: offset %2 is missing or not a whole number</source>
        <translation>%1&#x202f;: le décalage %2 manque ou n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>exactly %1</source>
        <translation>exactement %1</translation>
    </message>
    <message>
        <source>%1: number of corners: declared %2</source>
        <translation>%1&#x202f;: nombre de coins&#x202f;: annoncé %2</translation>
    </message>
    <message>
        <source>%1, the last offset</source>
        <translation>%1, le dernier décalage</translation>
    </message>
    <message>
        <source>number of cells</source>
        <translation>nombre de cellules</translation>
    </message>
    <message>
        <source>number of values</source>
        <translation>nombre de valeurs</translation>
    </message>
    <message>
        <source>number of cell types</source>
        <translation>nombre de types de cellules</translation>
    </message>
    <message>
        <source>%1, one for each cell</source>
        <translation>%1, une par cellule</translation>
    </message>
    <message>
        <source>%1: a value is missing or not a whole number</source>
        <translation>%1&#x202f;: une valeur manque ou n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>length of a text: %1 bytes</source>
        <translation>longueur d’un texte&#x202f;: %1 octets</translation>
    </message>
    <message>
        <source>at most %1, the number of bytes that follow</source>
        <translation>au plus %1, le nombre d’octets suivants</translation>
    </message>
    <message>
        <source>number of arrays</source>
        <translation>nombre de tableaux</translation>
    </message>
    <message>
        <source>number of components</source>
        <translation>nombre de composantes</translation>
    </message>
    <message>
        <source>number of tuples</source>
        <translation>nombre de tuples</translation>
    </message>
    <message>
        <source>array %1: %2</source>
        <translation>tableau %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>number of values: declared %1, of type %2</source>
        <translation>nombre de valeurs&#x202f;: annoncé %1, de type %2</translation>
    </message>
    <message>
        <source>a known type and as many numbers as are declared</source>
        <translation>un type connu et autant de nombres qu’annoncé</translation>
    </message>
    <message>
        <source>a second section %1</source>
        <translation>une deuxième section %1</translation>
    </message>
    <message>
        <source>each section once</source>
        <translation>chaque section une fois</translation>
    </message>
    <message>
        <source>a VTK file of type %1</source>
        <translation>un fichier VTK de type %1</translation>
    </message>
    <message>
        <source>the type %1</source>
        <translation>le type %1</translation>
    </message>
    <message>
        <source>one of the keywords %1</source>
        <translation>l’un des mots-clés %1</translation>
    </message>
    <message>
        <source>colours not read: those of %1</source>
        <translation>couleurs non lues&#x202f;: celles de %1</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>une archive ZIP</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <translation>une image PNG</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>an SQLite database (a recording?)</source>
        <translation>une base de données SQLite (un enregistrement&#x202f;?)</translation>
    </message>
    <message>
        <source>a mesh in one of the formats %1</source>
        <translation>un maillage dans l’un des formats %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>a web page (HTML), perhaps a failed download</source>
        <translation>une page web (HTML), peut-être un téléchargement manqué</translation>
    </message>
    <message>
        <source>a Git LFS pointer, not the file itself (fetch it with `git lfs pull`)</source>
        <translation>un pointeur Git LFS, non le fichier lui-même (à récupérer par `git lfs pull`)</translation>
    </message>
    <message>
        <source>is %1, which Palpate does not read</source>
        <translation>est %1, que Palpate ne lit pas</translation>
    </message>
    <message>
        <source>a mesh saved in one of the formats %1</source>
        <translation>un maillage enregistré dans l’un des formats %1</translation>
    </message>
    <message>
        <source>the content is no known mesh format</source>
        <translation>le contenu n’est d’aucun format de maillage connu</translation>
    </message>
    <message>
        <source>three numbers after %1</source>
        <translation>trois nombres après %1</translation>
    </message>
    <message>
        <source>%1 is not a vertex index</source>
        <translation>%1 n’est pas un indice de sommet</translation>
    </message>
    <message>
        <source>whole numbers after %1</source>
        <translation>des nombres entiers après %1</translation>
    </message>
    <message>
        <source>vertex index %1 (number of vertices so far: %2)</source>
        <translation>indice de sommet %1 (nombre de sommets jusque-là&#x202f;: %2)</translation>
    </message>
    <message>
        <source>indices from 1, or negative indices that count back from the last vertex</source>
        <translation>des indices à partir de 1, ou des indices négatifs qui comptent à rebours depuis le dernier sommet</translation>
    </message>
    <message>
        <source>a face with one corner</source>
        <translation>une face d’un seul coin</translation>
    </message>
    <message>
        <source>a face with %1 corners</source>
        <translation>une face de %1 coins</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>vertex index %1</source>
        <translation>indice de sommet %1</translation>
    </message>
    <message>
        <source>at most %1, the number of vertices</source>
        <translation>au plus %1, le nombre de sommets</translation>
    </message>
    <message>
        <source>colours not read: those of its material</source>
        <translation>couleurs non lues&#x202f;: celles du matériau</translation>
    </message>
    <message>
        <source>colours not read: those of its %1 materials</source>
        <translation>couleurs non lues&#x202f;: celles des %1 matériaux</translation>
    </message>
    <message>
        <source>number of line, point and curve elements that are ignored: %1</source>
        <translation>nombre d’éléments de ligne, de point et de courbe ignorés&#x202f;: %1</translation>
    </message>
    <message>
        <source>colours not read: those of its vertices</source>
        <translation>couleurs non lues&#x202f;: celles des sommets</translation>
    </message>
    <message>
        <source>the file ends in a line; that line is lost</source>
        <translation>le fichier finit au milieu d’une ligne&#x202f;; cette ligne est perdue</translation>
    </message>
    <message>
        <source>a mesh saved as STL, PLY, OBJ or VTK (MeshLab or Blender convert it)</source>
        <translation>un maillage enregistré en STL, PLY, OBJ ou VTK (MeshLab ou Blender le convertissent)</translation>
    </message>
    <message>
        <source>a mesh in VTK format: convert it with FreeSurfer&apos;s mris_convert to a name that ends in .vtk</source>
        <translation>un maillage au format VTK&#x202f;: le convertir avec mris_convert de FreeSurfer en un fichier dont le nom finit par .vtk</translation>
    </message>
    <message>
        <source>an AppleDouble file, in which macOS keeps the attributes of another file</source>
        <translation>un fichier AppleDouble, où macOS range les attributs d’un autre fichier</translation>
    </message>
    <message>
        <source>the file of the same name without &quot;._&quot;</source>
        <translation>le fichier du même nom sans «&#x202f;._&#x202f;»</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un fichier glTF</translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation>un fichier FBX</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>un fichier Blender</translation>
    </message>
    <message>
        <source>a mesh exported from Blender as STL, PLY or OBJ</source>
        <translation>un maillage exporté de Blender en STL, PLY ou OBJ</translation>
    </message>
    <message>
        <source>a Gmsh mesh</source>
        <translation>un maillage Gmsh</translation>
    </message>
    <message>
        <source>its surface saved as VTK or STL (Gmsh: Export)</source>
        <translation>sa surface enregistrée en VTK ou STL (Gmsh&#x202f;: Export)</translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation>un fichier VRML</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>un modèle STEP</translation>
    </message>
    <message>
        <source>a mesh made of it (FreeCAD: Export as STL)</source>
        <translation>un maillage qui en est tiré (FreeCAD&#x202f;: exporter en STL)</translation>
    </message>
    <message>
        <source>a 3D Slicer scene (MRML)</source>
        <translation>une scène de 3D Slicer (MRML)</translation>
    </message>
    <message>
        <source>an AMF file</source>
        <translation>un fichier AMF</translation>
    </message>
    <message>
        <source>a COLLADA file</source>
        <translation>un fichier COLLADA</translation>
    </message>
    <message>
        <source>an X3D file</source>
        <translation>un fichier X3D</translation>
    </message>
    <message>
        <source>a JSON document</source>
        <translation>un document JSON</translation>
    </message>
    <message>
        <source>a mesh, or a scene of Palpate with a name that ends in .json</source>
        <translation>un maillage, ou une scène de Palpate dont le nom finit par .json</translation>
    </message>
    <message>
        <source>%1 is not a number, in element %2 %3 of %4</source>
        <translation>%1 n’est pas un nombre, dans l’élément %2 %3 sur %4</translation>
    </message>
    <message>
        <source>the file ends in element %1 %2 of %3</source>
        <translation>le fichier finit dans l’élément %1 %2 sur %3</translation>
    </message>
    <message>
        <source>vertex %1: %2</source>
        <translation>sommet %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>number of corners of face %1: %2</source>
        <translation>nombre de coins de la face %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>face %1 uses vertex %2</source>
        <translation>la face %1 utilise le sommet %2</translation>
    </message>
    <message>
        <source>the property %1</source>
        <translation>la propriété %1</translation>
    </message>
    <message>
        <source>element %1 %2: length of a list: %3</source>
        <translation>élément %1 %2&#x202f;: longueur d’une liste&#x202f;: %3</translation>
    </message>
    <message>
        <source>header</source>
        <translation>en-tête</translation>
    </message>
    <message>
        <source>no faces with a list of vertex indices</source>
        <translation>aucune face avec une liste d’indices de sommets</translation>
    </message>
    <message>
        <source>found the element %1</source>
        <translation>trouvé l’élément %1</translation>
    </message>
    <message>
        <source>%1, then %2, once each</source>
        <translation>%1, puis %2, une fois chacun</translation>
    </message>
    <message>
        <source>no vertices with x, y and z</source>
        <translation>aucun sommet avec x, y et z</translation>
    </message>
    <message>
        <source>one of each</source>
        <translation>un de chaque</translation>
    </message>
    <message>
        <source>number of vertices: %1, of faces: %2</source>
        <translation>nombre de sommets&#x202f;: %1, de faces&#x202f;: %2</translation>
    </message>
    <message>
        <source>at most %1 of each</source>
        <translation>au plus %1 de chaque</translation>
    </message>
    <message>
        <source>more data after the last element</source>
        <translation>des données après le dernier élément</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>0 faces</source>
        <translation>aucune face</translation>
    </message>
    <message>
        <source>at least one face</source>
        <translation>au moins une face</translation>
    </message>
    <message>
        <source>lines with more numbers than the header declares: %1; the surplus is left out</source>
        <translation>lignes avec plus de nombres que n’en annonce l’en-tête&#x202f;: %1&#x202f;; le surplus est omis</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 faces lost</source>
        <translation>le fichier finit là&#x202f;: %1 faces sur %2 perdues</translation>
    </message>
    <message>
        <source>the format %1</source>
        <translation>le format %1</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 ou %3</translation>
    </message>
    <message>
        <source>the element count %1</source>
        <translation>le nombre d’éléments %1</translation>
    </message>
    <message>
        <source>a type and a name, below an element</source>
        <translation>un type et un nom, sous un élément</translation>
    </message>
    <message>
        <source>lines of the header that are none of PLY left out: %1</source>
        <translation>lignes d’en-tête étrangères à PLY, omises&#x202f;: %1</translation>
    </message>
    <message>
        <source>the header has no line %1</source>
        <translation>l’en-tête n’a pas de ligne %1</translation>
    </message>
    <message>
        <source>one such line</source>
        <translation>une telle ligne</translation>
    </message>
    <message>
        <source>the file ends in the header</source>
        <translation>le fichier finit dans l’en-tête</translation>
    </message>
    <message>
        <source>colours not read: those of its elements %1</source>
        <translation>couleurs non lues&#x202f;: celles des éléments %1</translation>
    </message>
    <message>
        <source>number of elements %1: declared %2</source>
        <translation>nombre d’éléments %1&#x202f;: annoncé %2</translation>
    </message>
    <message>
        <source>at most %1, as many as the %2 bytes that follow can hold</source>
        <translation>au plus %1, autant que les %2 octets suivants peuvent en contenir</translation>
    </message>
    <message>
        <source>coordinates are not numbers in %1 of %2 triangles (first: triangle %3)</source>
        <translation>des coordonnées ne sont pas des nombres dans %1 triangles sur %2 (premier&#x202f;: triangle %3)</translation>
    </message>
    <message>
        <source>coordinates are farther than 10 km from the origin in %1 of %2 triangles (first: triangle %3)</source>
        <translation>des coordonnées sont à plus de 10 km de l’origine dans %1 triangles sur %2 (premier&#x202f;: triangle %3)</translation>
    </message>
    <message>
        <source>coordinates are not numbers, or farther than 10 km from the origin, in %1 of %2 triangles (first: triangle %3)</source>
        <translation>des coordonnées ne sont pas des nombres, ou sont à plus de 10 km de l’origine, dans %1 triangles sur %2 (premier&#x202f;: triangle %3)</translation>
    </message>
    <message>
        <source>the last triangle is whole, but the attribute behind it is cut off</source>
        <translation>le dernier triangle est entier, mais l’attribut qui le suit est coupé</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 triangles lost</source>
        <translation>le fichier finit là&#x202f;: %1 triangles sur %2 perdus</translation>
    </message>
    <message>
        <source>cut off: the binary STL declares %1 triangles, but the %2 bytes hold %3</source>
        <translation>coupé&#x202f;: le STL binaire annonce %1 triangles, mais les %2 octets en contiennent %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 bytes; --partial opens the first %2 of %3 triangles</source>
        <translation>%1 octets&#x202f;; --partial ouvre les %2 premiers des %3 triangles</translation>
    </message>
    <message>
        <source>number of triangles of the binary STL: declared %1, but the %2 bytes hold %3</source>
        <translation>nombre de triangles du STL binaire&#x202f;: annoncé %1, mais les %2 octets en contiennent %3</translation>
    </message>
    <message>
        <source>colours not read: those of %1 of the triangles, as a structure has one colour</source>
        <translation>couleurs non lues&#x202f;: celles de %1 des triangles, car une structure a une seule couleur</translation>
    </message>
    <message>
        <source>the file ends in the STL header</source>
        <translation>le fichier finit dans l’en-tête STL</translation>
    </message>
    <message>
        <source>at least %1 bytes</source>
        <translation>au moins %1 octets</translation>
    </message>
    <message>
        <source>a number in the range of %1</source>
        <translation>un nombre dans la plage de %1</translation>
    </message>
    <message>
        <source>a blank or a line end after it</source>
        <translation>une espace ou une fin de ligne après</translation>
    </message>
    <message>
        <source>its type is %1</source>
        <translation>son type est %1</translation>
    </message>
    <message>
        <source>size of its data: %1 bytes</source>
        <translation>taille de ses données&#x202f;: %1 octets</translation>
    </message>
    <message>
        <source>a multiple of %1 bytes</source>
        <translation>un multiple de %1 octets</translation>
    </message>
    <message>
        <source>value %1 is %2</source>
        <translation>la valeur %1 est %2</translation>
    </message>
    <message>
        <source>a number of type %1</source>
        <translation>un nombre de type %1</translation>
    </message>
    <message>
        <source>number of values: %1</source>
        <translation>nombre de valeurs&#x202f;: %1</translation>
    </message>
    <message>
        <source>number of points: declared %1, but there is no array of points</source>
        <translation>nombre de points&#x202f;: annoncé %1, mais il n’y a pas de tableau de points</translation>
    </message>
    <message>
        <source>an array of points</source>
        <translation>un tableau de points</translation>
    </message>
    <message>
        <source>number of components: %1</source>
        <translation>nombre de composantes&#x202f;: %1</translation>
    </message>
    <message>
        <source>its compressed data are damaged</source>
        <translation>ses données compressées sont endommagées</translation>
    </message>
    <message>
        <source>data that can be decompressed</source>
        <translation>des données qui se décompressent</translation>
    </message>
    <message>
        <source>%1: declared %2 cells, but an array is missing</source>
        <translation>%1&#x202f;: %2 cellules annoncées, mais un tableau manque</translation>
    </message>
    <message>
        <source>the arrays %1 and %2</source>
        <translation>les tableaux %1 et %2</translation>
    </message>
    <message>
        <source>its type is %1, its number of components %2</source>
        <translation>son type est %1, son nombre de composantes %2</translation>
    </message>
    <message>
        <source>whole numbers with one component</source>
        <translation>des nombres entiers à une composante</translation>
    </message>
    <message>
        <source>value %1 is point %2</source>
        <translation>la valeur %1 est le point %2</translation>
    </message>
    <message>
        <source>character %1 is %2</source>
        <translation>le caractère %1 est %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>its last string has no end</source>
        <translation>sa dernière chaîne n’a pas de fin</translation>
    </message>
    <message>
        <source>a zero after each string</source>
        <translation>un zéro après chaque chaîne</translation>
    </message>
    <message>
        <source>number of tuples: declared %1, of components in each: %2</source>
        <translation>nombre de tuples&#x202f;: annoncé %1, de composantes dans chacun&#x202f;: %2</translation>
    </message>
    <message>
        <source>exactly %1 values, as many as it contains</source>
        <translation>exactement %1 valeurs, autant qu’il en contient</translation>
    </message>
    <message>
        <source>at most %1 values, as many as it contains</source>
        <translation>au plus %1 valeurs, autant qu’il en contient</translation>
    </message>
    <message>
        <source>colours not read: the array %1 of its points</source>
        <translation>couleurs non lues&#x202f;: le tableau %1 des points</translation>
    </message>
    <message>
        <source>colours not read: the array %1 of its polygons</source>
        <translation>couleurs non lues&#x202f;: le tableau %1 des polygones</translation>
    </message>
    <message>
        <source>%1, one for each point</source>
        <translation>%1, une pour chaque point</translation>
    </message>
    <message>
        <source>%1, one for each polygon</source>
        <translation>%1, une pour chaque polygone</translation>
    </message>
    <message>
        <source>the array %1 is damaged and not used</source>
        <translation>le tableau %1 est endommagé et n’est pas utilisé</translation>
    </message>
    <message>
        <source>number of elements: declared %1</source>
        <translation>nombre d’éléments&#x202f;: annoncé %1</translation>
    </message>
    <message>
        <source>number of points: %1, of polygons and strips: %2</source>
        <translation>nombre de points&#x202f;: %1, de polygones et de bandes&#x202f;: %2</translation>
    </message>
    <message>
        <source>the cells have no types</source>
        <translation>les cellules n’ont pas de types</translation>
    </message>
    <message>
        <source>the array %1</source>
        <translation>le tableau %1</translation>
    </message>
    <message>
        <source>number of points: %1</source>
        <translation>nombre de points&#x202f;: %1</translation>
    </message>
    <message>
        <source>the file ends in the header of its data</source>
        <translation>le fichier finit dans l’en-tête de ses données</translation>
    </message>
    <message>
        <source>size of its data: declared %1 bytes</source>
        <translation>taille de ses données&#x202f;: annoncé %1 octets</translation>
    </message>
    <message>
        <source>at most %1, the number of characters that follow</source>
        <translation>au plus %1, le nombre de caractères suivants</translation>
    </message>
    <message>
        <source>block %1 reaches beyond the end of the file; its size is %2 bytes</source>
        <translation>le bloc %1 dépasse la fin du fichier&#x202f;; sa taille est de %2 octets</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>au plus %1 octets</translation>
    </message>
    <message>
        <source>block %1: declared sizes are %2 bytes compressed and %3 bytes decompressed</source>
        <translation>bloc %1&#x202f;: les tailles annoncées sont %2 octets compressés et %3 octets décompressés</translation>
    </message>
    <message>
        <source>at most %1 bytes decompressed</source>
        <translation>au plus %1 octets décompressés</translation>
    </message>
    <message>
        <source>number of blocks: declared %1</source>
        <translation>nombre de blocs&#x202f;: annoncé %1</translation>
    </message>
    <message>
        <source>at most %1, the number of header words that follow</source>
        <translation>au plus %1, le nombre de mots d’en-tête suivants</translation>
    </message>
    <message>
        <source>block size %1 bytes, size of the last block %2 bytes</source>
        <translation>taille de bloc %1 octets, taille du dernier bloc %2 octets</translation>
    </message>
    <message>
        <source>a block size of at least one byte and a last block that is not larger</source>
        <translation>une taille de bloc d’au moins un octet et un dernier bloc qui ne soit pas plus grand</translation>
    </message>
    <message>
        <source>its data begin at offset %1</source>
        <translation>ses données commencent au décalage %1</translation>
    </message>
    <message>
        <source>less than %1, the length of the appended data</source>
        <translation>moins de %1, la longueur des données annexées</translation>
    </message>
    <message>
        <source>found %1=%2</source>
        <translation>trouvé %1=%2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>the compressor %1</source>
        <translation>le compresseur %1</translation>
    </message>
    <message>
        <source>found an array %1 under %2</source>
        <translation>trouvé un tableau %1 sous %2</translation>
    </message>
    <message>
        <source>one array of points, one array %1 and one array %2</source>
        <translation>un tableau de points, un tableau %1 et un tableau %2</translation>
    </message>
    <message>
        <source>found an element %1 under %2</source>
        <translation>trouvé un élément %1 sous %2</translation>
    </message>
    <message>
        <source>an XML document of type %1</source>
        <translation>un document XML de type %1</translation>
    </message>
    <message>
        <source>found a document type or an entity</source>
        <translation>trouvé un type de document ou une entité</translation>
    </message>
    <message>
        <source>elements nested in more than %1 levels</source>
        <translation>éléments imbriqués sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>au plus %1 niveaux</translation>
    </message>
    <message>
        <source>invalid XML: %1</source>
        <translation>XML non valide&#x202f;: %1</translation>
    </message>
    <message>
        <source>well-formed XML to the end of the file</source>
        <translation>du XML bien formé jusqu’à la fin du fichier</translation>
    </message>
    <message>
        <source>the appended data do not begin with %1</source>
        <translation>les données annexées ne commencent pas par %1</translation>
    </message>
    <message>
        <source>%1 and the data</source>
        <translation>%1 et les données</translation>
    </message>
    <message>
        <source>more than 2 GiB of XML</source>
        <translation>plus de 2 GiB de XML</translation>
    </message>
    <message>
        <source>arrays as appended data</source>
        <translation>des tableaux en données annexées</translation>
    </message>
    <message>
        <source>no element %1</source>
        <translation>aucun élément %1</translation>
    </message>
    <message>
        <source>at least one such element</source>
        <translation>au moins un tel élément</translation>
    </message>
    <message>
        <source>not enough memory to read it: %1</source>
        <translation>pas assez de mémoire pour le lire&#x202f;: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu&#x202f;: %1</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>le fichier est devenu plus court pendant la lecture</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>un fichier lisible</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert&#x202f;: %1</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>un fichier de maillage</translation>
    </message>
    <message>
        <source>the frame SPACE=%1 is not used: expected LPS or RAS</source>
        <translation>le repère SPACE=%1 n’est pas utilisé&#x202f;; attendu LPS ou RAS</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header is not used: expected %2 to %3</source>
        <translation>SCALE=%1 dans l’en-tête n’est pas utilisé&#x202f;; attendu %2 à %3</translation>
    </message>
    <message>
        <source>1 vertex without finite coordinates left out: no face uses it</source>
        <translation>1 sommet sans coordonnées finies omis&#x202f;: aucune face ne l’utilise</translation>
    </message>
    <message>
        <source>%1 vertices without finite coordinates left out: no face uses them</source>
        <translation>%1 sommets sans coordonnées finies omis&#x202f;: aucune face ne les utilise</translation>
    </message>
    <message>
        <source>1 face of fewer than 3 corners left out</source>
        <translation>1 face de moins de 3 sommets omise</translation>
    </message>
    <message>
        <source>%1 faces of fewer than 3 corners left out</source>
        <translation>%1 faces de moins de 3 sommets omises</translation>
    </message>
    <message>
        <source>1 hidden cell left out</source>
        <translation>1 cellule masquée omise</translation>
    </message>
    <message>
        <source>%1 hidden cells left out</source>
        <translation>%1 cellules masquées omises</translation>
    </message>
    <message>
        <source>1 byte behind the last face left out</source>
        <translation>1 octet après la dernière face omis</translation>
    </message>
    <message>
        <source>%1 bytes behind the last face left out</source>
        <translation>%1 octets après la dernière face omis</translation>
    </message>
    <message>
        <source>0 faces, but %1 points: a point cloud</source>
        <translation>0 face, mais %1 points&#x202f;: un nuage de points</translation>
    </message>
    <message>
        <source>a surface: reconstruct one first (MeshLab: Screened Poisson)</source>
        <translation>une surface&#x202f;: en reconstruire une d’abord (MeshLab&#x202f;: Screened Poisson)</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number (%1)</source>
        <translation>une coordonnée n’est pas un nombre fini (%1)</translation>
    </message>
    <message>
        <source>a coordinate is farther than 10 km from the origin (%1)</source>
        <translation>une coordonnée est à plus de 10 km de l’origine (%1)</translation>
    </message>
    <message>
        <source>header: %1</source>
        <translation>en-tête&#x202f;: %1</translation>
    </message>
    <message>
        <source>no file %1</source>
        <translation>aucun fichier %1</translation>
    </message>
    <message>
        <source>each field once</source>
        <translation>chaque champ une fois</translation>
    </message>
    <message>
        <source>one of the two</source>
        <translation>l’un des deux</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 axes</translation>
    </message>
    <message>
        <source>%1 voxels along axis %2</source>
        <translation>%1 voxels le long de l’axe %2</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>le XML est défectueux&#x202f;: %1</translation>
    </message>
    <message>
        <source>a %1 volume with more than %2 intensities, not labels</source>
        <translation>un volume %1 avec plus de %2 intensités, pas des étiquettes</translation>
    </message>
    <message>
        <source>a %1 volume with %2 intensities, not labels</source>
        <translation>un volume %1 avec %2 intensités, pas des étiquettes</translation>
    </message>
    <message>
        <source>a label map with %1 labels</source>
        <translation>une carte d’étiquettes avec %1 étiquettes</translation>
    </message>
    <message>
        <source>at most %1 labels</source>
        <translation>au plus %1 étiquettes</translation>
    </message>
    <message>
        <source>a %1 volume without labels: every voxel is 0</source>
        <translation>un volume %1 sans étiquettes&#x202f;: chaque voxel vaut 0</translation>
    </message>
    <message>
        <source>at least one voxel with a label</source>
        <translation>au moins un voxel avec une étiquette</translation>
    </message>
    <message>
        <source>a file that can be read</source>
        <translation>un fichier lisible</translation>
    </message>
    <message>
        <source>content in proportion to the size of the file</source>
        <translation>un contenu en rapport avec la taille du fichier</translation>
    </message>
    <message>
        <source>the process to read it could not be started</source>
        <translation>le processus qui devait le lire n’a pas pu démarrer</translation>
    </message>
    <message>
        <source>room for one more process with some open files and memory (`ulimit -a` lists the limits)</source>
        <translation>de la place pour un processus de plus avec quelques fichiers ouverts et de la mémoire (`ulimit -a` énumère les limites)</translation>
    </message>
    <message>
        <source>reading it took more than %1 s of processor time</source>
        <translation>sa lecture a pris plus de %1 s de temps processeur</translation>
    </message>
    <message>
        <source>a file that can be read in this time</source>
        <translation>un fichier lisible en ce temps</translation>
    </message>
    <message>
        <source>its content is larger than %1 MiB</source>
        <translation>son contenu dépasse %1 MiB</translation>
    </message>
    <message>
        <source>the system ended the process that read it, perhaps because memory ran out</source>
        <translation>le système a arrêté le processus qui le lisait, peut-être faute de mémoire</translation>
    </message>
    <message>
        <source>a smaller file, or more free memory</source>
        <translation>un fichier plus petit ou plus de mémoire libre</translation>
    </message>
    <message>
        <source>the process that read it crashed (%1)</source>
        <translation>le processus qui le lisait s’est arrêté brutalement (%1)</translation>
    </message>
    <message>
        <source>the process to read it could not limit its memory and time</source>
        <translation>le processus qui devait le lire n’a pas pu limiter sa mémoire et son temps</translation>
    </message>
    <message>
        <source>limits of this program above its own limits (`ulimit -a` lists them)</source>
        <translation>des limites de ce programme supérieures à celles du processus (`ulimit -a` les énumère)</translation>
    </message>
    <message>
        <source>the process that read it could not write the result</source>
        <translation>le processus qui le lisait n’a pas pu écrire le résultat</translation>
    </message>
    <message>
        <source>enough memory and no lower limit on the size of files (`ulimit -v`, `ulimit -f`)</source>
        <translation>assez de mémoire et pas de limite inférieure sur la taille des fichiers (`ulimit -v`, `ulimit -f`)</translation>
    </message>
    <message>
        <source>the process that read it ended with exit code %1</source>
        <translation>le processus qui le lisait a fini avec le code de retour %1</translation>
    </message>
    <message>
        <source>the process to read it could not be started: %1</source>
        <translation>le processus qui devait le lire n’a pas pu démarrer&#x202f;: %1</translation>
    </message>
    <message>
        <source>reading it took more than %1 s</source>
        <translation>sa lecture a pris plus de %1 s</translation>
    </message>
    <message>
        <source>reading it takes more than %1 MiB of memory</source>
        <translation>sa lecture demande plus de %1 MiB de mémoire</translation>
    </message>
    <message>
        <source>a coordinate is not finite or is farther than 10 km from the origin</source>
        <translation>une coordonnée n’est pas finie ou est à plus de 10 km de l’origine</translation>
    </message>
    <message>
        <source>a vertex index is out of range</source>
        <translation>un indice de sommet est hors limites</translation>
    </message>
    <message>
        <source>an array is incomplete</source>
        <translation>un tableau est incomplet</translation>
    </message>
    <message>
        <source>its frame is unknown</source>
        <translation>son repère est inconnu</translation>
    </message>
    <message>
        <source>its unit is not positive and finite</source>
        <translation>son unité n’est pas positive et finie</translation>
    </message>
    <message>
        <source>its voxels have no size or no axes</source>
        <translation>ses voxels n’ont pas de taille ou pas d’axes</translation>
    </message>
    <message>
        <source>a colour is out of range</source>
        <translation>une couleur est hors limites</translation>
    </message>
    <message>
        <source>a count is out of range</source>
        <translation>un nombre d’éléments est hors limites</translation>
    </message>
    <message>
        <source>its counts do not match its size</source>
        <translation>ses nombres d’éléments ne correspondent pas à sa taille</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header: a unit of the file is taken as %2 mm</source>
        <translation>SCALE=%1 dans l’en-tête&#x202f;: une unité du fichier est prise comme %2 mm</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header: not used, because the unit was given</source>
        <translation>SCALE=%1 dans l’en-tête&#x202f;: non utilisé, car l’unité était donnée</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>a positive number of millimetres per unit of the file</source>
        <translation>un nombre positif de millimètres par unité du fichier</translation>
    </message>
    <message>
        <source>not enough memory to read it</source>
        <translation>pas assez de mémoire pour le lire</translation>
    </message>
    <message>
        <source>polygon %1</source>
        <translation>polygone %1</translation>
    </message>
    <message>
        <source>number of corners: %1</source>
        <translation>nombre de coins&#x202f;: %1</translation>
    </message>
    <message>
        <source>it uses point %1</source>
        <translation>il utilise le point %1</translation>
    </message>
    <message>
        <source>at most %1 arrays of the points are used; number of arrays left out: %2</source>
        <translation>au plus %1 tableaux des points sont utilisés&#x202f;; nombre de tableaux laissés de côté&#x202f;: %2</translation>
    </message>
    <message>
        <source>at most %1 arrays of the polygons are used; number of arrays left out: %2</source>
        <translation>au plus %1 tableaux des polygones sont utilisés&#x202f;; nombre de tableaux laissés de côté&#x202f;: %2</translation>
    </message>
    <message>
        <source>one polygon has no simple outline</source>
        <translation>un polygone n’a pas de contour simple</translation>
    </message>
    <message>
        <source>%1 polygons have no simple outline</source>
        <translation>%1 polygones n’ont pas de contour simple</translation>
    </message>
    <message>
        <source>%1 components per voxel</source>
        <translation>%1 composantes par voxel</translation>
    </message>
    <message>
        <source>one number for each voxel</source>
        <translation>un nombre pour chaque voxel</translation>
    </message>
    <message>
        <source>%1 voxels declared</source>
        <translation>%1 voxels annoncés</translation>
    </message>
    <message>
        <source>as many as its %1 bytes can hold</source>
        <translation>autant que ses %1 octets peuvent en contenir</translation>
    </message>
    <message>
        <source>%1 bytes when unpacked</source>
        <translation>%1 octets une fois décompressés</translation>
    </message>
    <message>
        <source>%1 bytes of voxels</source>
        <translation>%1 octets de voxels</translation>
    </message>
    <message>
        <source>a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz</source>
        <translation>un volume&#x202f;: .vti, .mha, .mhd, .nrrd, .nhdr, .nii ou .nii.gz</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>aucun nombre</translation>
    </message>
    <message>
        <source>%1 numbers for %2 voxels</source>
        <translation>%1 nombres pour %2 voxels</translation>
    </message>
    <message>
        <source>VTK could not read it: %1</source>
        <translation>VTK n’a pas pu le lire&#x202f;: %1</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>fichier introuvable</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>a smaller volume, or more free memory</source>
        <translation>un volume plus petit, ou plus de mémoire libre</translation>
    </message>
    <message>
        <source>its axes are not finite numbers</source>
        <translation>ses axes ne sont pas des nombres finis</translation>
    </message>
    <message>
        <source>its voxels are incomplete</source>
        <translation>ses voxels sont incomplets</translation>
    </message>
    <message>
        <source>a valid %1 file</source>
        <translation>un fichier %1 valide</translation>
    </message>
    <message>
        <source>number of points read by VTK: %1, of polygons: %2</source>
        <translation>nombre de points lus par VTK&#x202f;: %1, de polygones&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>the result of the import process is damaged: %1</source>
        <translation>le résultat du processus d’importation est endommagé&#x202f;: %1</translation>
    </message>
    <message>
        <source>a result that passed all checks</source>
        <translation>un résultat qui ait passé tous les contrôles</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>il est vide</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>son en-tête n’a pas de fin</translation>
    </message>
    <message>
        <source>its header is incomplete</source>
        <translation>son en-tête est incomplet</translation>
    </message>
    <message>
        <source>it has an error without a message</source>
        <translation>il contient une erreur sans message</translation>
    </message>
    <message>
        <source>the file name %1</source>
        <translation>le nom de fichier %1</translation>
    </message>
    <message>
        <source>a file in this folder or below it</source>
        <translation>un fichier dans ce dossier ou plus bas</translation>
    </message>
    <message>
        <source>more than %1 files</source>
        <translation>plus de %1 fichiers</translation>
    </message>
    <message>
        <source>a VTK file without either</source>
        <translation>un fichier VTK sans l’un ni l’autre</translation>
    </message>
    <message>
        <source>a series of %1 time steps</source>
        <translation>une série de %1 pas de temps</translation>
    </message>
    <message>
        <source>one time step: open the file of that step</source>
        <translation>un pas de temps&#x202f;: ouvrir le fichier de ce pas</translation>
    </message>
    <message>
        <source>it names no files</source>
        <translation>il ne nomme aucun fichier</translation>
    </message>
    <message>
        <source>at least one element %1</source>
        <translation>au moins un élément %1</translation>
    </message>
    <message>
        <source>no column %1</source>
        <translation>aucune colonne %1</translation>
    </message>
    <message>
        <source>a header with %1 and %2</source>
        <translation>un en-tête avec %1 et %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 est %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>au moins un</translation>
    </message>
    <message>
        <source>%1: taken as %2, as the scene file says; not as %3</source>
        <translation>%1&#x202f;: lu comme %2, comme l’indique le fichier de scène&#x202f;; pas comme %3</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>le dossier ne peut pas être lu&#x202f;: %1</translation>
    </message>
    <message>
        <source>a folder of meshes</source>
        <translation>un dossier de maillages</translation>
    </message>
    <message>
        <source>a folder without mesh files</source>
        <translation>un dossier sans fichiers de maillage</translation>
    </message>
    <message>
        <source>%1 files in it</source>
        <translation>%1 fichiers dedans</translation>
    </message>
    <message>
        <source>%1: changed since the scene was saved: found SHA-256 %2..., expected %3...; opened as it is now</source>
        <translation>%1&#x202f;: modifié depuis l’enregistrement de la scène&#x202f;: SHA-256 trouvé&#x202f;: %2..., attendu&#x202f;: %3...&#x202f;; ouvert dans son état actuel</translation>
    </message>
    <message>
        <source>no structure %1</source>
        <translation>aucune structure %1</translation>
    </message>
    <message>
        <source>one of that name</source>
        <translation>une de ce nom</translation>
    </message>
    <message>
        <source>%1: all triangles have zero area (number of triangles: %2); expected at least one with an area</source>
        <translation>%1&#x202f;: tous les triangles ont une aire nulle (nombre de triangles&#x202f;: %2)&#x202f;; attendu&#x202f;: au moins un d’aire non nulle</translation>
    </message>
    <message>
        <source>%1: tagged SPACE=%2, but taken as %3, as was chosen</source>
        <translation>%1&#x202f;: étiqueté SPACE=%2, mais lu comme %3, selon le choix fait</translation>
    </message>
    <message>
        <source>%1: tagged SPACE=RAS: x and y negated to get LPS</source>
        <translation>%1&#x202f;: étiqueté SPACE=RAS&#x202f;: signes de x et de y inversés pour obtenir LPS</translation>
    </message>
    <message>
        <source>%1 and %2 more files: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1 et %2 autres fichiers&#x202f;: pas d’étiquette SPACE&#x202f;: coordonnées lues comme LPS</translation>
    </message>
    <message>
        <source>%1 and %2: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1 et %2&#x202f;: pas d’étiquette SPACE&#x202f;: coordonnées lues comme LPS</translation>
    </message>
    <message>
        <source>%1: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1&#x202f;: pas d’étiquette SPACE&#x202f;: coordonnées lues comme LPS</translation>
    </message>
    <message>
        <source>%1: only %2 units wide, taken as mm; looks like metres: open with --unit m</source>
        <translation>%1&#x202f;: large de %2 unités seulement, lues comme des mm&#x202f;; sans doute des mètres&#x202f;: ouvrir avec --unit m</translation>
    </message>
    <message>
        <source>%1: %2 units wide, with units of %3 mm; looks like millimetres: open with --unit mm</source>
        <translation>%1&#x202f;: large de %2 unités de %3 mm&#x202f;; sans doute des millimètres&#x202f;: ouvrir avec --unit mm</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>omis&#x202f;: %1</translation>
    </message>
    <message>
        <source>not enough memory to open it</source>
        <translation>pas assez de mémoire pour l’ouvrir</translation>
    </message>
    <message>
        <source>a smaller scene, or more free memory</source>
        <translation>une scène plus petite, ou plus de mémoire libre</translation>
    </message>
    <message>
        <source>a matrix that is not rigid</source>
        <translation>une matrice qui n’est pas rigide</translation>
    </message>
    <message>
        <source>a rotation and a translation, row by row</source>
        <translation>une rotation et une translation, ligne par ligne</translation>
    </message>
    <message>
        <source>at most `static`, which is %1</source>
        <translation>au plus `static`, soit %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>un de %1</translation>
    </message>
    <message>
        <source>neither `array` nor `file`</source>
        <translation>ni `array` ni `file`</translation>
    </message>
    <message>
        <source>both `array` and `file`</source>
        <translation>à la fois `array` et `file`</translation>
    </message>
    <message>
        <source>the unit of the numbers: scale, N_per_mm, young_kPa or shear_kPa</source>
        <translation>l’unité des nombres&#x202f;: scale, N_per_mm, young_kPa ou shear_kPa</translation>
    </message>
    <message>
        <source>a unit of `%1`</source>
        <translation>une unité de `%1`</translation>
    </message>
    <message>
        <source>a larger number before a smaller one</source>
        <translation>un nombre plus grand avant un plus petit</translation>
    </message>
    <message>
        <source>the minimum, then the maximum</source>
        <translation>le minimum, puis le maximum</translation>
    </message>
    <message>
        <source>%1 together with `inside`</source>
        <translation>%1 en même temps que `inside`</translation>
    </message>
    <message>
        <source>one of the two: a structure felt through its organ has no layer of its own</source>
        <translation>l’un des deux&#x202f;: une structure sentie à travers son organe n’a pas de couche propre</translation>
    </message>
    <message>
        <source>its own name</source>
        <translation>son propre nom</translation>
    </message>
    <message>
        <source>the name of the organ around it</source>
        <translation>le nom de l’organe qui l’entoure</translation>
    </message>
    <message>
        <source>the path of a mesh file</source>
        <translation>le chemin d’un maillage</translation>
    </message>
    <message>
        <source>LPS, RAS or Y-up</source>
        <translation>LPS, RAS ou Y-up</translation>
    </message>
    <message>
        <source>a fraction</source>
        <translation>une fraction</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>64 hex digits</source>
        <translation>64 chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>the path of a recording</source>
        <translation>le chemin d’un enregistrement</translation>
    </message>
    <message>
        <source>a time in UTC, e.g. %1</source>
        <translation>une heure UTC, par exemple %1</translation>
    </message>
    <message>
        <source>the name of a structure of this scene</source>
        <translation>le nom d’une structure de cette scène</translation>
    </message>
    <message>
        <source>`felt:` and a quantity, or `array:` and its name</source>
        <translation>`felt:` et une grandeur, ou `array:` et son nom</translation>
    </message>
    <message>
        <source>%1, the name of %2 structures</source>
        <translation>%1, le nom de %2 structures</translation>
    </message>
    <message>
        <source>the name of one structure: rename the others</source>
        <translation>le nom d’une seule structure&#x202f;: renommer les autres</translation>
    </message>
    <message>
        <source>%1, which lies inside %2</source>
        <translation>%1, qui est à l’intérieur de %2</translation>
    </message>
    <message>
        <source>the outermost structure around it</source>
        <translation>la structure la plus externe qui l’entoure</translation>
    </message>
    <message>
        <source>a scene as a JSON object</source>
        <translation>une scène comme objet JSON</translation>
    </message>
    <message>
        <source>both `points` and `file`</source>
        <translation>à la fois `points` et `file`</translation>
    </message>
    <message>
        <source>points [[depth_mm, force_N], …] or the file of a curve</source>
        <translation>des points [[depth_mm, force_N], …] ou le fichier d’une courbe</translation>
    </message>
    <message>
        <source>not smoothed: too small, it would lose more than half of its volume</source>
        <translation>non lissée&#x202f;: trop petite, elle perdrait plus de la moitié de son volume</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, %4</source>
        <translation>surface d’une carte d’étiquettes à voxels de %1 × %2 × %3 mm, %4</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: at most %5 mm from the voxel boundary</source>
        <translation>surface d’une carte d’étiquettes à voxels de %1 × %2 × %3 mm, lissée de %4&#x202f;: à %5 mm au plus de la limite des voxels</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm</source>
        <translation>lissée&#x202f;: sommets déplacés de %1 mm au plus</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: volume changed by %5 %, at most %6 mm from the voxel boundary</source>
        <translation>surface d’une carte d’étiquettes à voxels de %1 × %2 × %3 mm, lissée de %4&#x202f;: volume modifié de %5 %, à %6 mm au plus de la limite des voxels</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm, volume %2 %</source>
        <translation>lissée&#x202f;: sommets déplacés de %1 mm au plus, volume %2 %</translation>
    </message>
    <message>
        <source>curved facets would be %1 triangles, expected at most %2; the surface is felt and drawn as facets</source>
        <translation>les facettes courbes donneraient %1 triangles, attendu au plus %2&#x202f;; la surface est ressentie et dessinée en facettes planes</translation>
    </message>
    <message>
        <source>no facet is curved: all edges are flat or sharp</source>
        <translation>aucune facette n’est courbée&#x202f;: toutes les arêtes sont planes ou vives</translation>
    </message>
    <message>
        <source>curved facets: %1 triangles instead of %2; facets kept flat, because they would fold: %3</source>
        <translation>facettes courbes&#x202f;: %1 triangles au lieu de %2&#x202f;; facettes laissées planes, car elles se replieraient&#x202f;: %3</translation>
    </message>
    <message>
        <source>curved facets: %1 triangles instead of %2</source>
        <translation>facettes courbes&#x202f;: %1 triangles au lieu de %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
    <message>
        <source>it is farther than 10 km from the origin</source>
        <translation>il est à plus de 10 km de l’origine</translation>
    </message>
    <message>
        <source>all triangles have zero area (number of triangles: %1)</source>
        <translation>tous les triangles ont une aire nulle (nombre de triangles&#x202f;: %1)</translation>
    </message>
    <message>
        <source>at least one with an area</source>
        <translation>au moins un d’aire non nulle</translation>
    </message>
    <message>
        <source>a mesh with arrays: this one has none</source>
        <translation>un maillage avec des tableaux&#x202f;: celui-ci n’en a pas</translation>
    </message>
    <message>
        <source>the volume</source>
        <translation>le volume</translation>
    </message>
    <message>
        <source>%1: %2 has no value at %3 of %4 places, more than a fifth: the structure&apos;s own value is felt there</source>
        <translation>%1&#x202f;: %2 n’a pas de valeur en %3 points sur %4, plus d’un cinquième&#x202f;: la valeur propre de la structure s’y sent</translation>
    </message>
    <message>
        <source>%1: %2 has no value at %3 of %4 places: the structure&apos;s own value is felt there</source>
        <translation>%1&#x202f;: %2 n’a pas de valeur en %3 points sur %4&#x202f;: la valeur propre de la structure s’y sent</translation>
    </message>
    <message>
        <source>no array %1</source>
        <translation>aucun tableau %1</translation>
    </message>
    <message>
        <source>%1; expected %2</source>
        <translation>%1&#x202f;; attendu %2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1&#x202f;: %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>an array of %1</source>
        <translation>un tableau de %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>%1: %2: found %3, expected %4</source>
        <translation>%1&#x202f;: %2&#x202f;: trouvé&#x202f;: %3, attendu&#x202f;: %4</translation>
    </message>
    <message>
        <source>a text without the character U+0000</source>
        <translation>un texte sans le caractère U+0000</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>vrai ou faux</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 nombres</translation>
    </message>
    <message>
        <source>at most %1 pairs of numbers</source>
        <translation>au plus %1 paires de nombres</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>deux nombres</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>a byte of 0 in the header</source>
        <translation>un octet 0 dans l’en-tête</translation>
    </message>
    <message>
        <source>%1 a second time</source>
        <translation>%1 une seconde fois</translation>
    </message>
    <message>
        <source>the header does not end</source>
        <translation>l’en-tête ne se termine pas</translation>
    </message>
    <message>
        <source>3 or 4</source>
        <translation>3 ou 4</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>a type of number, as MET_UCHAR or MET_SHORT</source>
        <translation>un type de nombre, comme MET_UCHAR ou MET_SHORT</translation>
    </message>
    <message>
        <source>True: voxels as binary numbers</source>
        <translation>True&#x202f;: des voxels en nombres binaires</translation>
    </message>
    <message>
        <source>one file, or uncompressed files in a LIST</source>
        <translation>un fichier, ou des fichiers non compressés dans une LIST</translation>
    </message>
    <message>
        <source>the name of one file, or LIST and one name on each line</source>
        <translation>le nom d’un fichier, ou LIST et un nom par ligne</translation>
    </message>
    <message>
        <source>no complete header of a NIfTI file</source>
        <translation>pas d’en-tête complet d’un fichier NIfTI</translation>
    </message>
    <message>
        <source>348 or 540 bytes</source>
        <translation>348 ou 540 octets</translation>
    </message>
    <message>
        <source>voxels in a separate .img file</source>
        <translation>des voxels dans un fichier .img séparé</translation>
    </message>
    <message>
        <source>a single file: save it as .nii or .nii.gz</source>
        <translation>un seul fichier&#x202f;: enregistrez-le en .nii ou .nii.gz</translation>
    </message>
    <message>
        <source>header: datatype</source>
        <translation>en-tête&#x202f;: datatype</translation>
    </message>
    <message>
        <source>one number for each voxel, as 2 or 4</source>
        <translation>un nombre par voxel, comme 2 ou 4</translation>
    </message>
    <message>
        <source>header: vox_offset</source>
        <translation>en-tête&#x202f;: vox_offset</translation>
    </message>
    <message>
        <source>the byte of the first voxel, %1 or more</source>
        <translation>l’octet du premier voxel, %1 ou plus</translation>
    </message>
    <message>
        <source>a field and its value</source>
        <translation>un champ et sa valeur</translation>
    </message>
    <message>
        <source>a type of number, as &quot;uchar&quot; or &quot;short&quot;</source>
        <translation>un type de nombre, comme &quot;uchar&quot; ou &quot;short&quot;</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot;</source>
        <translation>&quot;little&quot; ou &quot;big&quot;</translation>
    </message>
    <message>
        <source>&quot;raw&quot; or &quot;gzip&quot;</source>
        <translation>&quot;raw&quot; ou &quot;gzip&quot;</translation>
    </message>
    <message>
        <source>a vector of three numbers for each axis, or none</source>
        <translation>un vecteur de trois nombres pour chaque axe, ou none</translation>
    </message>
    <message>
        <source>three axes in space and, for overlapping segments, one list axis before or after them</source>
        <translation>trois axes spatiaux et, pour des segments qui se chevauchent, un axe de liste avant ou après eux</translation>
    </message>
    <message>
        <source>a vector of three numbers</source>
        <translation>un vecteur de trois nombres</translation>
    </message>
    <message>
        <source>one name on each line after LIST</source>
        <translation>un nom par ligne après LIST</translation>
    </message>
    <message>
        <source>1 to %1 voxels</source>
        <translation>1 à %1 voxels</translation>
    </message>
    <message>
        <source>voxels of %1 × %2 × %3 mm</source>
        <translation>voxels de %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>axes that lie in one plane</source>
        <translation>des axes situées dans un même plan</translation>
    </message>
    <message>
        <source>axes %1 and %2 are sheared by %3°</source>
        <translation>les axes %1 et %2 sont cisaillés de %3°</translation>
    </message>
    <message>
        <source>perpendicular axes: resample the volume first (3D Slicer: Resample Image)</source>
        <translation>des axes perpendiculaires&#x202f;: rééchantillonnez d’abord le volume (3D Slicer&#x202f;: Resample Image)</translation>
    </message>
    <message>
        <source>header: file of the voxels</source>
        <translation>en-tête&#x202f;: fichier des voxels</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of voxels</source>
        <translation>%1 octets de voxels sur %2</translation>
    </message>
    <message>
        <source>compressed data that are complete and undamaged</source>
        <translation>des données compressées complètes et intactes</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>damaged compressed data</source>
        <translation>des données compressées endommagées</translation>
    </message>
    <message>
        <source>more bytes than its %1 voxels have</source>
        <translation>plus d’octets que n’en ont ses %1 voxels</translation>
    </message>
    <message>
        <source>number of triangles to write: %1</source>
        <translation>nombre de triangles à écrire&#x202f;: %1</translation>
    </message>
    <message>
        <source>structure %1</source>
        <translation>structure %1</translation>
    </message>
    <message>
        <source>a triangle with a missing vertex</source>
        <translation>un triangle dont un sommet manque</translation>
    </message>
    <message>
        <source>indices below %1</source>
        <translation>des indices inférieurs à %1</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>l’extension %1</translation>
    </message>
    <message>
        <source>the program has locked its memory itself</source>
        <translation>le programme a lui-même verrouillé sa mémoire</translation>
    </message>
    <message>
        <source>structure %1 (%2) has no surface to embed; pass StructureSource::embed to setScene, or record without surfaces</source>
        <translation>la structure %1 (%2) n’a pas de surface à intégrer&#x202f;; passez StructureSource::embed à setScene, ou enregistrez sans surfaces</translation>
    </message>
    <message>
        <source>lumps felt through their organ: %1</source>
        <translation>nodules sentis à travers leur organe&#x202f;: %1</translation>
    </message>
    <message>
        <source>malignant tumour of the liver</source>
        <translation>tumeur maligne du foie</translation>
    </message>
    <message>
        <source>benign tumour of the liver</source>
        <translation>tumeur bénigne du foie</translation>
    </message>
    <message>
        <source>tumour of the liver</source>
        <translation>tumeur du foie</translation>
    </message>
    <message>
        <source>fibrotic liver</source>
        <translation>foie fibreux</translation>
    </message>
    <message>
        <source>cancer of the prostate</source>
        <translation>cancer de la prostate</translation>
    </message>
    <message>
        <source>nodule of the prostate</source>
        <translation>nodule de la prostate</translation>
    </message>
    <message>
        <source>malignant tumour of the breast</source>
        <translation>tumeur maligne du sein</translation>
    </message>
    <message>
        <source>benign tumour of the breast</source>
        <translation>tumeur bénigne du sein</translation>
    </message>
    <message>
        <source>tumour of the breast</source>
        <translation>tumeur du sein</translation>
    </message>
    <message>
        <source>malignant nodule of the thyroid</source>
        <translation>nodule malin de la thyroïde</translation>
    </message>
    <message>
        <source>benign nodule of the thyroid</source>
        <translation>nodule bénin de la thyroïde</translation>
    </message>
    <message>
        <source>nodule of the thyroid</source>
        <translation>nodule de la thyroïde</translation>
    </message>
    <message>
        <source>cancer of the pancreas</source>
        <translation>cancer du pancréas</translation>
    </message>
    <message>
        <source>benign tumour of the pancreas</source>
        <translation>tumeur bénigne du pancréas</translation>
    </message>
    <message>
        <source>tumour of the pancreas</source>
        <translation>tumeur du pancréas</translation>
    </message>
    <message>
        <source>cyst</source>
        <translation>kyste</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>vaisseau</translation>
    </message>
    <message>
        <source>%1 %2 (%3 to %4)</source>
        <translation>%1 %2 (%3 à %4)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the stiffness ratio to %2 is not known, so no verdict is given; expected a ratio, as --ratio &quot;%1=R&quot; or `young_ratio` in a scene file. Published: %3</source>
        <translation>%1&#x202f;: le rapport de rigidité à %2 n’est pas connu, donc aucun verdict&#x202f;; attendu&#x202f;: un rapport, par --ratio &quot;%1=R&quot; ou `young_ratio` dans un fichier de scène. Publié&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1 and %2 are the same surface twice</source>
        <translation>%1 et %2 sont deux fois la même surface</translation>
    </message>
    <message>
        <source>%1 lies in %2, which is felt in the last of %3 layers: both are felt in that one</source>
        <translation>%1 est dans %2, qui se sent dans la dernière des %3 couches&#x202f;: les deux se sentent dans celle-là</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt below it</source>
        <translation>%1 est dans %2 et se sent dessous</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it</source>
        <translation>%1 semble être dans %2, dont la surface est ouverte ou retournée&#x202f;: il ne se sent pas dessous</translation>
    </message>
    <message>
        <source>%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into the gap, a fingertip of 0.5 mm or more rides over it</source>
        <translation>%1 et %2 s’approchent à %3 mm en (%4, %5, %6) sans se toucher&#x202f;: un point tombe dans l’interstice, un bout de doigt de 0,5 mm ou plus passe dessus</translation>
    </message>
    <message>
        <source>%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam</source>
        <translation>%1 et %2 se touchent dans une même couche et leurs rigidités diffèrent d’un facteur %3&#x202f;: la force fait un saut à la jonction</translation>
    </message>
    <message>
        <source>%1 lies in %2 and in the same layer: it is never felt; a deeper layer lets it be felt (--layers auto for mesh files, the field layer in a scene file)</source>
        <translation>%1 est dans %2 et dans la même couche&#x202f;: il ne se sent jamais&#x202f;; une couche plus profonde le rend palpable (--layers auto pour des maillages, le champ layer dans un fichier de scène)</translation>
    </message>
    <message>
        <source>%1 lies in %2 and in the same layer: it is felt only where it reaches out; a deeper layer lets it be felt (--layers auto for mesh files, the field layer in a scene file)</source>
        <translation>%1 est dans %2 et dans la même couche&#x202f;: il ne se sent que là où il dépasse&#x202f;; une couche plus profonde le rend palpable (--layers auto pour des maillages, le champ layer dans un fichier de scène)</translation>
    </message>
    <message>
        <source>%1: %2: %3 (and %4 more)</source>
        <translation>%1&#x202f;: %2&#x202f;: %3 (et %4 de plus)</translation>
    </message>
    <message>
        <source>found version %1, expected 1.0: read as far as it is the same</source>
        <translation>version trouvée&#x202f;: %1, attendue&#x202f;: 1.0&#x202f;; lue dans la mesure où elle est identique</translation>
    </message>
    <message>
        <source>found no version, expected 1.0: read as far as it is the same</source>
        <translation>aucune version trouvée, attendue&#x202f;: 1.0&#x202f;; lue dans la mesure où elle est identique</translation>
    </message>
    <message>
        <source>found %1, expected LPS or RAS: the list is left out</source>
        <translation>trouvé&#x202f;: %1, attendu&#x202f;: LPS ou RAS&#x202f;; la liste est laissée de côté</translation>
    </message>
    <message>
        <source>found another unit, expected mm or um: the list is left out</source>
        <translation>autre unité trouvée, attendu&#x202f;: mm ou um&#x202f;; la liste est laissée de côté</translation>
    </message>
    <message>
        <source>found more than %1 points: left out</source>
        <translation>plus de %1 points trouvés&#x202f;: laissés de côté</translation>
    </message>
    <message>
        <source>found no position: left out</source>
        <translation>aucune position trouvée&#x202f;: laissé de côté</translation>
    </message>
    <message>
        <source>found a coordinate that is not a number within 10⁷ mm: left out</source>
        <translation>coordonnée trouvée qui n’est pas un nombre dans la limite de 10⁷ mm&#x202f;: laissée de côté</translation>
    </message>
    <message>
        <source>found a text of %1 characters, expected at most %2: shortened</source>
        <translation>texte de %1 caractères trouvé, attendu&#x202f;: au plus %2&#x202f;; raccourci</translation>
    </message>
    <message>
        <source>%1: found none of the surfaces that it was made on: %2</source>
        <translation>%1&#x202f;: aucune des surfaces de son enregistrement n’a été trouvée&#x202f;: %2</translation>
    </message>
    <message>
        <source>it contains none and names no mesh</source>
        <translation>il n’en contient aucune et ne nomme aucun maillage</translation>
    </message>
    <message>
        <source>%1: %2: no such file, neither where it was nor beside the recording</source>
        <translation>%1&#x202f;: %2&#x202f;: fichier introuvable, ni à son ancien emplacement ni à côté de l’enregistrement</translation>
    </message>
    <message>
        <source>%1: %2: is another surface now than was recorded; opened as it is now</source>
        <translation>%1&#x202f;: %2&#x202f;: n’est plus la surface de l’enregistrement&#x202f;; ouverte dans son état actuel</translation>
    </message>
    <message>
        <source>%1: its recorded map is of another surface; it is not felt</source>
        <translation>%1&#x202f;: sa carte enregistrée est celle d’une autre surface&#x202f;; elle ne se sent pas</translation>
    </message>
    <message>
        <source>%1: the recorded effect of its lumps is of another surface; it is not felt</source>
        <translation>%1&#x202f;: l’effet enregistré de ses nodules est celui d’une autre surface&#x202f;; il ne se sent pas</translation>
    </message>
    <message>
        <source>%1 (in English)</source>
        <translation>%1 (en anglais)</translation>
    </message>
    <message>
        <source>polygon %1 has %2 corners, expected 3 to %3</source>
        <translation>le polygone %1 a %2 coins, attendu 3 à %3</translation>
    </message>
    <message>
        <source>polygon %1 uses point %2, expected 0 to %3</source>
        <translation>le polygone %1 utilise le point %2, attendu 0 à %3</translation>
    </message>
    <message>
        <source>found no points, expected a surface; was the filter before it updated?</source>
        <translation>aucun point trouvé, attendu une surface&#x202f;; le filtre précédent a-t-il été mis à jour&#x202f;?</translation>
    </message>
    <message>
        <source>unit_mm: found %1, expected more than 0 and at most %2</source>
        <translation>unit_mm&#x202f;: trouvé %1, attendu plus de 0 et au plus %2</translation>
    </message>
    <message>
        <source>found %1 values for %2 vertices and %3 points, expected one for each vertex of a surface from surfaceOf</source>
        <translation>%1 valeurs trouvées pour %2 sommets et %3 points, attendu une par sommet d’une surface de surfaceOf</translation>
    </message>
    <message>
        <source>%1 is not what the generator makes</source>
        <translation>%1 n’est pas ce que le générateur produit</translation>
    </message>
    <message>
        <source>%1: tick %2 is not what the generator makes</source>
        <translation>%1&#x202f;: le cycle %2 n’est pas ce que le générateur produit</translation>
    </message>
    <message>
        <source>its coordinates are not finite numbers</source>
        <translation>ses coordonnées ne sont pas des nombres finis</translation>
    </message>
    <message>
        <source>%1: the recording holds no tick; there is nothing to play</source>
        <translation>%1&#x202f;: l’enregistrement ne contient aucun cycle&#x202f;; il n’y a rien à lire</translation>
    </message>
    <message>
        <source>%1 includes what it encloses, %2 voxels of other labels</source>
        <translation>%1 contient ce qu’il entoure&#x202f;: %2 voxels d’autres étiquettes</translation>
    </message>
    <message>
        <source>%1: left out, %2; --close-holes closes holes</source>
        <translation>%1&#x202f;: omis, %2&#x202f;; --close-holes ferme les trous</translation>
    </message>
    <message>
        <source>found no device plugin called &quot;%1&quot;, expected one of: %2 (the built-in devices %3 are not plugins)</source>
        <translation>aucun greffon d’appareil nommé «&#x202f;%1&#x202f;» trouvé, attendu l’un de&#x202f;: %2 (les appareils intégrés %3 ne sont pas des greffons)</translation>
    </message>
    <message>
        <source>found %1 vertices and a lattice of %2 mm, expected more than 0</source>
        <translation>%1 sommets et une grille de %2 mm trouvés, plus de 0 est attendu</translation>
    </message>
    <message>
        <source>frame %1: found %2 vertices, expected %3 as at rest</source>
        <translation>image %1&#x202f;: %2 sommets trouvés, %3 sont attendus comme au repos</translation>
    </message>
    <message>
        <source>frame %1, vertex %2: found a number that is not finite</source>
        <translation>image %1, sommet %2&#x202f;: un nombre n’est pas fini</translation>
    </message>
    <message>
        <source>frame %1, vertex %2: found %3 mm between the shape and the lattice of %4 mm, expected at most %5 mm: use a finer lattice, or one structure for each part that slides</source>
        <translation>image %1, sommet %2&#x202f;: %3 mm trouvés entre la forme et la grille de %4 mm, au plus %5 mm sont attendus&#x202f;: utilisez une grille plus fine ou une structure pour chaque partie qui glisse</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3 to %4</source>
        <translation>%1&#x202f;: trouvé&#x202f;: %2, attendu&#x202f;: de %3 à %4</translation>
    </message>
    <message>
        <source>found %1 poses, expected at least two</source>
        <translation>%1 poses trouvées, au moins deux sont attendues</translation>
    </message>
    <message>
        <source>exponent: found %1, expected an even number from 2 to %2</source>
        <translation>exponent&#x202f;: %1 trouvé, un nombre pair de 2 à %2 est attendu</translation>
    </message>
    <message>
        <source>amplitude_mm, still or full: found a number that is not finite</source>
        <translation>amplitude_mm, still ou full&#x202f;: un nombre n’est pas fini</translation>
    </message>
    <message>
        <source>frame %1: found %2 control points, expected %3</source>
        <translation>image %1&#x202f;: %2 points de contrôle trouvés, %3 sont attendus</translation>
    </message>
    <message>
        <source>pose %1: found a number that is not finite</source>
        <translation>pose %1&#x202f;: un nombre n’est pas fini</translation>
    </message>
    <message>
        <source>pose %1: found the time %2 s after %3 s, expected ascending times</source>
        <translation>pose %1&#x202f;: temps %2 s trouvé après %3 s, des temps croissants sont attendus</translation>
    </message>
    <message>
        <source>the last pose: found another than the first, expected the same for a motion that repeats</source>
        <translation>la dernière pose&#x202f;: différente de la première, la même est attendue pour un mouvement qui se répète</translation>
    </message>
    <message>
        <source>found %1 frames, expected at least two</source>
        <translation>%1 images trouvées, au moins deux sont attendues</translation>
    </message>
    <message>
        <source>amplitude_mm: found more than %1 mm</source>
        <translation>amplitude_mm&#x202f;: plus de %1 mm trouvés</translation>
    </message>
    <message>
        <source>lattice: expected at least one cell of a positive size</source>
        <translation>grille&#x202f;: au moins une cellule de taille positive est attendue</translation>
    </message>
    <message>
        <source>lattice: found %1 control points in %2 frames, expected at most %3</source>
        <translation>grille&#x202f;: %1 points de contrôle dans %2 images trouvés, au plus %3 sont attendus</translation>
    </message>
    <message>
        <source>lattice: found %1 displacements, expected %2</source>
        <translation>grille&#x202f;: %1 déplacements trouvés, %2 sont attendus</translation>
    </message>
    <message>
        <source>frame %1, control point %2: found the displacement %3 mm</source>
        <translation>image %1, point de contrôle %2&#x202f;: déplacement de %3 mm trouvé</translation>
    </message>
    <message>
        <source>frame %1, cell (%2, %3, %4): found a strain of up to %5 %, where the tissue may fold; expected at most %6 %</source>
        <translation>image %1, cellule (%2, %3, %4)&#x202f;: déformation de %5 % trouvée, où le tissu peut se replier&#x202f;; au plus %6 % est attendu</translation>
    </message>
    <message>
        <source>frame %1, cell (%2, %3, %4): found a strain of up to %5 %, expected at most %6 %</source>
        <translation>image %1, cellule (%2, %3, %4)&#x202f;: déformation de %5 % trouvée, au plus %6 % est attendu</translation>
    </message>
    <message>
        <source>found %1 bytes that are no motion of this version, expected one that Palpate wrote</source>
        <translation>%1 octets trouvés qui ne sont pas un mouvement de cette version, un mouvement écrit par Palpate est attendu</translation>
    </message>
    <message>
        <source>found %1 layers with different motions, expected at most %2: let structures of a layer move alike</source>
        <translation>%1 couches aux mouvements différents trouvées, au plus %2 sont attendues&#x202f;: donnez le même mouvement aux structures d’une couche</translation>
    </message>
    <message>
        <source>the gzip file is cut off</source>
        <translation>le fichier gzip est tronqué</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>le fichier entier</translation>
    </message>
    <message>
        <source>at most %1 times the size of the file: unpack it first (gunzip)</source>
        <translation>au plus %1 fois la taille du fichier&#x202f;: décompressez-le d’abord (gunzip)</translation>
    </message>
    <message>
        <source>more than %1 bytes when unpacked</source>
        <translation>plus de %1 octets une fois décompressé</translation>
    </message>
    <message>
        <source>the gzip data are cut off or damaged</source>
        <translation>les données gzip sont tronquées ou endommagées</translation>
    </message>
    <message>
        <source>%1 bytes, as its end states: unpack it with gunzip, which names the damage</source>
        <translation>%1 octets, comme l’indique sa fin&#x202f;: décompressez-le avec gunzip, qui nomme le dommage</translation>
    </message>
    <message>
        <source>a FreeSurfer surface of quadrangles, or its values</source>
        <translation>une surface FreeSurfer de quadrilatères, ou ses valeurs</translation>
    </message>
    <message>
        <source>the files of its models, or the scene with a name that ends in .mrml</source>
        <translation>les fichiers de ses modèles, ou la scène avec un nom qui finit par .mrml</translation>
    </message>
    <message>
        <source>an opacity is out of range</source>
        <translation>une opacité est hors limites</translation>
    </message>
    <message>
        <source>%1: %2 is not opened: %3</source>
        <translation>%1&#x202f;: %2 n’est pas ouvert&#x202f;: %3</translation>
    </message>
    <message>
        <source>the scene names no file of it</source>
        <translation>la scène n’en nomme aucun fichier</translation>
    </message>
    <message>
        <source>the file %1 is not in the folder of the scene</source>
        <translation>le fichier %1 n’est pas dans le dossier de la scène</translation>
    </message>
    <message>
        <source>its transform is not a rotation, shift and scale: harden it in 3D Slicer</source>
        <translation>sa transformation n’est pas une rotation, une translation et une mise à l’échelle&#x202f;: appliquez-la dans 3D Slicer (Harden)</translation>
    </message>
    <message>
        <source>a scene without models and segmentations</source>
        <translation>une scène sans modèles ni segmentations</translation>
    </message>
    <message>
        <source>at least one (3D Slicer: File, Save Data)</source>
        <translation>au moins un (3D Slicer&#x202f;: File, Save Data)</translation>
    </message>
    <message>
        <source>the FreeSurfer surface ends in its header</source>
        <translation>la surface FreeSurfer finit dans son en-tête</translation>
    </message>
    <message>
        <source>a text with an empty line after it, and the numbers of vertices and triangles</source>
        <translation>un texte suivi d’une ligne vide, et les nombres de sommets et de triangles</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles declared, %3 bytes behind them</source>
        <translation>%1 sommets et %2 triangles déclarés, suivis de %3 octets</translation>
    </message>
    <message>
        <source>moved by the centre of its volume, (%1, %2, %3) mm, to the coordinates of the scanner</source>
        <translation>déplacé du centre de son volume, (%1, %2, %3) mm, vers les coordonnées du scanner</translation>
    </message>
    <message>
        <source>%1, as declared</source>
        <translation>%1, comme déclaré</translation>
    </message>
    <message>
        <source>the data are not base64</source>
        <translation>les données ne sont pas en base64</translation>
    </message>
    <message>
        <source>base64, as declared</source>
        <translation>base64, comme déclaré</translation>
    </message>
    <message>
        <source>the data are cut off, damaged or too long</source>
        <translation>les données sont tronquées, endommagées ou trop longues</translation>
    </message>
    <message>
        <source>%1 bytes, as declared</source>
        <translation>%1 octets, comme déclaré</translation>
    </message>
    <message>
        <source>an array of %1 × %2 numbers</source>
        <translation>un tableau de %1 × %2 nombres</translation>
    </message>
    <message>
        <source>three numbers for each point or triangle, as many as its %1 bytes can hold</source>
        <translation>trois nombres par point ou triangle, autant que ses %1 octets peuvent contenir</translation>
    </message>
    <message>
        <source>numbers of the type %1 in the encoding %2</source>
        <translation>des nombres de type %1 dans l’encodage %2</translation>
    </message>
    <message>
        <source>%1 in ASCII, Base64Binary or GZipBase64Binary (wb_command -gifti-convert)</source>
        <translation>%1 en ASCII, Base64Binary ou GZipBase64Binary (wb_command -gifti-convert)</translation>
    </message>
    <message>
        <source>an array without data</source>
        <translation>un tableau sans données</translation>
    </message>
    <message>
        <source>a coordinate transform without 16 finite numbers</source>
        <translation>une transformation de coordonnées sans 16 nombres finis</translation>
    </message>
    <message>
        <source>4 × 4 numbers</source>
        <translation>4 × 4 nombres</translation>
    </message>
    <message>
        <source>a second array of %1</source>
        <translation>un deuxième tableau %1</translation>
    </message>
    <message>
        <source>one surface in a file</source>
        <translation>une surface par fichier</translation>
    </message>
    <message>
        <source>moved to the coordinates of the scanner, as the file states</source>
        <translation>déplacé vers les coordonnées du scanner, comme l’indique le fichier</translation>
    </message>
    <message>
        <source>a GIFTI file of values, without a surface</source>
        <translation>un fichier GIFTI de valeurs, sans surface</translation>
    </message>
    <message>
        <source>arrays of points and triangles: open the surface file (.surf.gii)</source>
        <translation>des tableaux de points et de triangles&#x202f;: ouvrez le fichier de la surface (.surf.gii)</translation>
    </message>
    <message>
        <source>the file ends</source>
        <translation>le fichier se termine</translation>
    </message>
    <message>
        <source>the declared points and polygons</source>
        <translation>les points et polygones déclarés</translation>
    </message>
    <message>
        <source>the MNI object has %1 in place of a count</source>
        <translation>l’objet MNI a %1 à la place d’un nombre</translation>
    </message>
    <message>
        <source>a whole number up to %1, as many as its bytes can hold</source>
        <translation>un nombre entier jusqu’à %1, autant que ses octets peuvent contenir</translation>
    </message>
    <message>
        <source>the kind of colours %1</source>
        <translation>le type de couleurs %1</translation>
    </message>
    <message>
        <source>an end of a polygon below the one before: %1</source>
        <translation>une fin de polygone inférieure à la précédente&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 behind the last polygon</source>
        <translation>%1 après le dernier polygone</translation>
    </message>
    <message>
        <source>one object of polygons</source>
        <translation>un seul objet de polygones</translation>
    </message>
    <message>
        <source>the declared vertices and faces</source>
        <translation>les sommets et faces déclarés</translation>
    </message>
    <message>
        <source>%1: four dimensions, or binary</source>
        <translation>%1&#x202f;: quatre dimensions, ou binaire</translation>
    </message>
    <message>
        <source>OFF as text with three coordinates for each vertex (MeshLab converts it)</source>
        <translation>OFF en texte avec trois coordonnées par sommet (MeshLab le convertit)</translation>
    </message>
    <message>
        <source>%1 is not a count</source>
        <translation>%1 n’est pas un nombre d’éléments</translation>
    </message>
    <message>
        <source>the numbers of vertices, faces and edges</source>
        <translation>les nombres de sommets, de faces et d’arêtes</translation>
    </message>
    <message>
        <source>the OFF file declares %1 vertices and %2 faces</source>
        <translation>le fichier OFF déclare %1 sommets et %2 faces</translation>
    </message>
    <message>
        <source>three numbers for each vertex</source>
        <translation>trois nombres par sommet</translation>
    </message>
    <message>
        <source>the number of corners of a face</source>
        <translation>le nombre de coins d’une face</translation>
    </message>
    <message>
        <source>the face has fewer corners than it declares</source>
        <translation>la face a moins de coins que déclaré</translation>
    </message>
    <message>
        <source>%1 vertex indices</source>
        <translation>%1 indices de sommets</translation>
    </message>
    <message>
        <source>%1 behind the last face</source>
        <translation>%1 après la dernière face</translation>
    </message>
    <message>
        <source>%1 vertices and %2 faces, as declared</source>
        <translation>%1 sommets et %2 faces, comme déclaré</translation>
    </message>
    <message>
        <source>colours, normals and further numbers of vertices and faces are not read</source>
        <translation>les couleurs, normales et autres nombres des sommets et des faces ne sont pas lus</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;: a map of its tissue or its motion is not there, or damaged</source>
        <translation>structure «&#x202f;%1&#x202f;»&#x202f;: une carte de son tissu ou son mouvement manque ou est endommagé</translation>
    </message>
    <message>
        <source>a map of its tissue or its motion is not in the recording, or damaged</source>
        <translation>une carte de son tissu ou son mouvement manque dans l’enregistrement ou est endommagé</translation>
    </message>
    <message>
        <source>the surface of %1 is inside out</source>
        <translation>la surface de %1 est retournée</translation>
    </message>
    <message>
        <source>more than two triangles of %1 meet at an edge</source>
        <translation>plus de deux triangles de %1 se rejoignent à une arête</translation>
    </message>
    <message>
        <source>the surface of %1 has a hole of %2 mm</source>
        <translation>la surface de %1 a un trou de %2 mm</translation>
    </message>
    <message>
        <source>the surface of %1 has %2 holes, the largest of %3 mm</source>
        <translation>la surface de %1 a %2 trous, le plus grand de %3 mm</translation>
    </message>
    <message>
        <source>found %1, expected points or a line: left out</source>
        <translation>trouvé %1, attendu des points ou une ligne&#x202f;: ignoré</translation>
    </message>
    <message>
        <source>found a line without two points: left out</source>
        <translation>trouvé une ligne sans deux points&#x202f;: ignorée</translation>
    </message>
    <message>
        <source>--bands: found &quot;%1&quot;, expected ascending distances in mm, as 5,10</source>
        <translation>--bands&#x202f;: «&#x202f;%1&#x202f;» trouvé, des distances croissantes en mm sont attendues, comme 5,10</translation>
    </message>
    <message>
        <source>an even number from 2 to 64</source>
        <translation>un nombre pair de 2 à 64</translation>
    </message>
    <message>
        <source>both `still_mm` and `full_mm`, or neither</source>
        <translation>`still_mm` et `full_mm` ensemble, ou aucun des deux</translation>
    </message>
    <message>
        <source>the same place as `still_mm`</source>
        <translation>le même lieu que `still_mm`</translation>
    </message>
    <message>
        <source>another place</source>
        <translation>un autre lieu</translation>
    </message>
    <message>
        <source>the path of a CSV file of poses</source>
        <translation>le chemin d’un fichier CSV de poses</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>at least two, at equal steps of the period</source>
        <translation>au moins deux, à intervalles égaux de la période</translation>
    </message>
    <message>
        <source>a header with time_s, x, y, z and optionally qw, qx, qy, qz</source>
        <translation>un en-tête avec time_s, x, y, z et au choix qw, qx, qy, qz</translation>
    </message>
    <message>
        <source>a quaternion of length %1</source>
        <translation>un quaternion de longueur %1</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 sommets</translation>
    </message>
    <message>
        <source>%1 as in %2: every frame has the same mesh</source>
        <translation>%1 comme dans %2&#x202f;: chaque image a le même maillage</translation>
    </message>
    <message>
        <source>%1: moves along the poses of %2</source>
        <translation>%1&#x202f;: se déplace selon les poses de %2</translation>
    </message>
    <message>
        <source>%1: moves by up to %2 mm in a period of %3 s, with a strain of up to %4 %</source>
        <translation>%1&#x202f;: se déplace de %2 mm au plus avec une période de %3 s et une déformation de %4 % au plus</translation>
    </message>
    <message>
        <source>%1: its force pulses by %2 % in a period of %3 s</source>
        <translation>%1&#x202f;: sa force pulse de %2 % avec une période de %3 s</translation>
    </message>
    <message>
        <source>%1 layers with different motions</source>
        <translation>%1 couches aux mouvements différents</translation>
    </message>
    <message>
        <source>at most %1: let the structures of a layer move alike</source>
        <translation>au plus %1&#x202f;: donnez le même mouvement aux structures d’une couche</translation>
    </message>
    <message>
        <source>at most %1 texts</source>
        <translation>au plus %1 textes</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, they cross or touch at %3</source>
        <translation>%1 à %2&#x202f;: 0 mm, elles se croisent ou se touchent en %3</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, %1 lies inside, %3 mm from the surface, from %4 to %5</source>
        <translation>%1 à %2&#x202f;: 0 mm, %1 est à l’intérieur, à %3 mm de la surface, de %4 à %5</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, %2 lies inside, %3 mm from the surface, from %4 to %5</source>
        <translation>%1 à %2&#x202f;: 0 mm, %2 est à l’intérieur, à %3 mm de la surface, de %4 à %5</translation>
    </message>
    <message>
        <source>%1 to %2: %3 mm, from %4 to %5</source>
        <translation>%1 à %2&#x202f;: %3 mm, de %4 à %5</translation>
    </message>
    <message>
        <source>inside: %1 %</source>
        <translation>à l’intérieur&#x202f;: %1 %</translation>
    </message>
    <message>
        <source>no volume: no part is closed (open edges: %1, edges of more than two triangles: %2)</source>
        <translation>pas de volume&#x202f;: aucune partie n’est fermée (arêtes libres&#x202f;: %1, arêtes de plus de deux triangles&#x202f;: %2)</translation>
    </message>
    <message>
        <source>no volume: the surface is inside out</source>
        <translation>pas de volume&#x202f;: la surface est retournée</translation>
    </message>
    <message>
        <source>the volume is that of the closed parts: %1 of %2</source>
        <translation>le volume est celui des parties fermées&#x202f;: %1 sur %2</translation>
    </message>
    <message>
        <source>--out: found &quot;%1&quot;, expected a name that ends in .pdf or .html</source>
        <translation>--out&#x202f;: «&#x202f;%1&#x202f;» trouvé, un nom finissant par .pdf ou .html était attendu</translation>
    </message>
    <message>
        <source>This report has no pictures: %1.</source>
        <translation>Ce rapport ne contient pas d’images&#x202f;: %1.</translation>
    </message>
    <message>
        <source>the report was cancelled</source>
        <translation>le rapport a été annulé</translation>
    </message>
    <message>
        <source>Drawing the pictures</source>
        <translation>Dessin des images</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
    <message>
        <source>a place as three numbers</source>
        <translation>un point sous forme de trois nombres</translation>
    </message>
    <message>
        <source>%1: is a list of 3D Slicer marks, not a Palpate scene: import it into a scene as findings, with File &gt; Import findings in the window, or with `palpate findings SCENE.palpate.json --import %1 --out NEW.palpate.json`</source>
        <translation>%1&#x202f;: est une liste de marques de 3D Slicer, non une scène de Palpate&#x202f;: l’importer dans une scène comme points repérés, par Fichier &gt; Importer des points repérés dans la fenêtre, ou par `palpate findings SCÈNE.palpate.json --import %1 --out NOUVELLE.palpate.json`</translation>
    </message>
    <message>
        <source>the path of a volume</source>
        <translation>le chemin d’un volume</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1: %2 mm, from %3 to %4</source>
        <translation>%1&#x202f;: %2 mm, de %3 à %4</translation>
    </message>
    <message>
        <source>&lt; %1 mm</source>
        <translation>&lt; %1 mm</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 à %2 mm</translation>
    </message>
    <message>
        <source>&gt; %1 mm</source>
        <translation>&gt; %1 mm</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1&#x202f;: %2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>+%1 %</source>
        <translation>+%1 %</translation>
    </message>
    <message>
        <source>lump</source>
        <translation>nodule</translation>
    </message>
    <message>
        <source>hard area</source>
        <translation>zone dure</translation>
    </message>
    <message>
        <source>soft area</source>
        <translation>zone molle</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>keep away</source>
        <translation>à éviter</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
    <message>
        <source>Palpation report</source>
        <translation>Rapport de palpation</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Recherche, formation et répétition de planification. Pas un dispositif médical.</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Examiner</source>
        <translation>Examinateur</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>Rapport établi</translation>
    </message>
    <message>
        <source>The hand was in contact for %1 s of %2 s. The greatest force was %3 N, the median %4 N. Marked findings: %5.</source>
        <translation>La main était en contact pendant %1 s sur %2 s. La force maximale était de %3 N, la médiane de %4 N. Points repérés&#x202f;: %5.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>The scene from the front with %1 findings and a scale bar.</source>
        <translation>La scène de face avec %1 points repérés et une échelle.</translation>
    </message>
    <message>
        <source>From the patient&apos;s left</source>
        <translation>Depuis la gauche du patient</translation>
    </message>
    <message>
        <source>The scene from the left with %1 findings and a scale bar.</source>
        <translation>La scène depuis la gauche avec %1 points repérés et une échelle.</translation>
    </message>
    <message>
        <source>The scale bar holds at the depth of the middle of the picture. Numbers are those of the findings.</source>
        <translation>L’échelle est valable à la profondeur du centre de l’image. Les numéros sont ceux des points repérés.</translation>
    </message>
    <message>
        <source>Findings as marked by the examiner; force and depth at the time of marking</source>
        <translation>Points repérés par l’examinateur&#x202f;; force et profondeur au moment du marquage</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Place (x y z) [mm]</source>
        <translation>Position (x y z) [mm]</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>Taille [mm]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>Marked at [s]</source>
        <translation>Marqué à [s]</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>How the findings were examined: contact within %1 mm of the place</source>
        <translation>Examen des points repérés&#x202f;: contact à moins de %1 mm de la position</translation>
    </message>
    <message>
        <source>Time in contact [s]</source>
        <translation>Durée de contact [s]</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Mean force [N]</source>
        <translation>Force moyenne [N]</translation>
    </message>
    <message>
        <source>Peak force [N]</source>
        <translation>Force maximale [N]</translation>
    </message>
    <message>
        <source>Findings felt through several layers, at the time of marking</source>
        <translation>Points perçus à travers plusieurs couches, au moment du marquage</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Points repérés</translation>
    </message>
    <message>
        <source>No findings were marked.</source>
        <translation>Aucun point n’a été repéré.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The place of finding %1, %2, with a scale bar.</source>
        <translation>La position du point repéré %1, %2, avec une échelle.</translation>
    </message>
    <message>
        <source>Pictures are shown of the first %1 of %2 findings.</source>
        <translation>Des images sont données pour les %1 premiers des %2 points repérés.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Notes of the examiner</source>
        <translation>Notes de l’examinateur</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Written at [s]</source>
        <translation>Écrite à [s]</translation>
    </message>
    <message>
        <source>%1 lies inside, %2 mm from the surface</source>
        <translation>%1 est à l’intérieur, à %2 mm de la surface</translation>
    </message>
    <message>
        <source>apart</source>
        <translation>séparées</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Distance [mm]</source>
        <translation>Distance [mm]</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Situation</translation>
    </message>
    <message>
        <source>Margins: share of the lump&apos;s surface by its distance to the structure [%]</source>
        <translation>Marges&#x202f;: part de la surface du nodule selon sa distance à la structure [%]</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>À l’intérieur</translation>
    </message>
    <message>
        <source>Distances and margins</source>
        <translation>Distances et marges</translation>
    </message>
    <message>
        <source>Distances were not measured, because the scene is missing.</source>
        <translation>Les distances n’ont pas été mesurées, car la scène manque.</translation>
    </message>
    <message>
        <source>There are no two structures to measure between.</source>
        <translation>Il n’y a pas deux structures entre lesquelles mesurer.</translation>
    </message>
    <message>
        <source>Volumes and areas</source>
        <translation>Volumes et aires</translation>
    </message>
    <message>
        <source>Sizes were not measured, because the scene is missing.</source>
        <translation>Les tailles n’ont pas été mesurées, car la scène manque.</translation>
    </message>
    <message>
        <source>Sizes of the structures</source>
        <translation>Tailles des structures</translation>
    </message>
    <message>
        <source>Ball of equal volume [mm]</source>
        <translation>Boule de même volume [mm]</translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation>Aire [cm²]</translation>
    </message>
    <message>
        <source>Extent x × y × z [mm]</source>
        <translation>Étendue x × y × z [mm]</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>Contact with each structure; forces are those of its own layer</source>
        <translation>Contact avec chaque structure&#x202f;; les forces sont celles de sa propre couche</translation>
    </message>
    <message>
        <source>Contact [s]</source>
        <translation>Contact [s]</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Appuis</translation>
    </message>
    <message>
        <source>95th percentile [N]</source>
        <translation>95ᵉ centile [N]</translation>
    </message>
    <message>
        <source>Peak depth [mm]</source>
        <translation>Profondeur maximale [mm]</translation>
    </message>
    <message>
        <source>Covered [%]</source>
        <translation>Couvert [%]</translation>
    </message>
    <message>
        <source>Longest dwell [s]</source>
        <translation>Plus long arrêt [s]</translation>
    </message>
    <message>
        <source>Searching (the contact moves faster than 10 mm/s) and pressing (slower)</source>
        <translation>Recherche (le contact se déplace à plus de 10 mm/s) et pression (plus lentement)</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phases</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Temps [s]</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>recherche</translation>
    </message>
    <message>
        <source>pressing</source>
        <translation>pression</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>Séance entière</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>En contact</translation>
    </message>
    <message>
        <source>%1 s, contacts: %2</source>
        <translation>%1 s, contacts&#x202f;: %2</translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation>Trajet de la main</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation>Trajet sur la surface</translation>
    </message>
    <message>
        <source>Force in contact</source>
        <translation>Force en contact</translation>
    </message>
    <message>
        <source>peak %1 N, mean %2 N, median %3 N, 95th percentile %4 N</source>
        <translation>maximum %1 N, moyenne %2 N, médiane %3 N, 95e centile %4 N</translation>
    </message>
    <message>
        <source>Depth in contact</source>
        <translation>Profondeur en contact</translation>
    </message>
    <message>
        <source>peak %1 mm, mean %2 mm, 95th percentile %3 mm</source>
        <translation>maximum %1 mm, moyenne %2 mm, 95e centile %3 mm</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Nothing was touched.</source>
        <translation>Rien n’a été touché.</translation>
    </message>
    <message>
        <source>Covered: share of the surface within %1 mm of the contact. 95th percentile: the force stayed below this value for 95 % of the contact time.</source>
        <translation>Couvert&#x202f;: part de la surface à moins de %1 mm du contact. 95e centile&#x202f;: la force est restée inférieure à cette valeur pendant 95 % du temps de contact.</translation>
    </message>
    <message>
        <source>Force over time</source>
        <translation>Force au cours du temps</translation>
    </message>
    <message>
        <source>The recording contains no ticks.</source>
        <translation>L’enregistrement ne contient aucun tick.</translation>
    </message>
    <message>
        <source>Smallest and greatest force of each of %1 spans of time; the numbers mark when the findings were marked</source>
        <translation>Force minimale et maximale de chacun de %1 intervalles de temps&#x202f;; les numéros indiquent quand les points ont été repérés</translation>
    </message>
    <message>
        <source>Curve of the force over %1 s, at most %2 N, with %3 findings.</source>
        <translation>Courbe de la force sur %1 s, au plus %2 N, avec %3 points repérés.</translation>
    </message>
    <message>
        <source>Checking the recording</source>
        <translation>Vérification de l’enregistrement</translation>
    </message>
    <message>
        <source>Reading the surfaces</source>
        <translation>Lecture des surfaces</translation>
    </message>
    <message>
        <source>Computing the recording again</source>
        <translation>Recalcul de l’enregistrement</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Mesure en cours</translation>
    </message>
    <message>
        <source>Computing what can be felt of lumps</source>
        <translation>Calcul de la palpabilité des nodules</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Mesure des distances</translation>
    </message>
    <message>
        <source>The recording was interrupted: %1.</source>
        <translation>L’enregistrement a été interrompu&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Ticks missing in the recording: %1.</source>
        <translation>Ticks manquants dans l’enregistrement&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The recording is damaged, or was changed after it was made. Damaged places: %1. Ticks that do not match their checksum are left out of all numbers.</source>
        <translation>L’enregistrement est endommagé ou a été modifié après coup. Endroits endommagés&#x202f;: %1. Les ticks dont la somme de contrôle est fausse sont exclus de tous les nombres.</translation>
    </message>
    <message>
        <source>The recording is damaged, or was changed after it was made: %1.</source>
        <translation>L’enregistrement est endommagé ou a été modifié après coup&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The recording was not computed again, so its forces are not verified: %1.</source>
        <translation>L’enregistrement n’a pas été recalculé, ses forces ne sont donc pas vérifiées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Computing the recording again gives other forces, so they are not verified: %1.</source>
        <translation>Le recalcul donne d’autres forces, elles ne sont donc pas vérifiées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Surfaces not available, so without coverage: %1.</source>
        <translation>Surfaces non disponibles, donc sans couverture&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The scene is not available, so pictures, sizes, distances and lumps are missing: %1.</source>
        <translation>La scène n’est pas disponible&#x202f;; images, tailles, distances et nodules manquent donc&#x202f;: %1.</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>pas à la main</translation>
    </message>
    <message>
        <source>by a trained hand</source>
        <translation>par une main exercée</translation>
    </message>
    <message>
        <source>plainly</source>
        <translation>nettement</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>stiffness ratio not known</source>
        <translation>rapport de raideur inconnu</translation>
    </message>
    <message>
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (à %2&#x202f;: %3&#x202f;; à %4&#x202f;: %5)</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>tel que saisi</translation>
    </message>
    <message>
        <source>from the moduli</source>
        <translation>d’après les modules</translation>
    </message>
    <message>
        <source>from the tissues&apos; stiffness</source>
        <translation>d’après la raideur des tissus</translation>
    </message>
    <message>
        <source>published for such lumps</source>
        <translation>publié pour de tels nodules</translation>
    </message>
    <message>
        <source>%1 (%2 to %3) times as stiff, %4</source>
        <translation>%1 fois (%2 à %3) plus raide, %4</translation>
    </message>
    <message>
        <source>%1 times as stiff, %2</source>
        <translation>%1 fois plus raide, %2</translation>
    </message>
    <message>
        <source>Which lumps a hand can find, as predicted by the model of buried lumps (an estimate), with the stiffness ratio to the organ that this rests on</source>
        <translation>Nodules qu’une main peut trouver d’après le modèle des nodules enfouis (une estimation), avec le rapport de raideur à l’organe sur lequel cela repose</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Rapport de raideur</translation>
    </message>
    <message>
        <source>Pressed %1 mm</source>
        <translation>Pressé de %1 mm</translation>
    </message>
    <message>
        <source>Touched lightly</source>
        <translation>Touché légèrement</translation>
    </message>
    <message>
        <source>How thoroughly each lump was searched for: recorded change of the force, and estimates of the model</source>
        <translation>Rigueur de la recherche de chaque nodule&#x202f;: variation enregistrée de la force et estimations du modèle</translation>
    </message>
    <message>
        <source>Largest recorded change under the hand</source>
        <translation>Plus grande variation enregistrée sous la main</translation>
    </message>
    <message>
        <source>Predicted change</source>
        <translation>Variation prédite</translation>
    </message>
    <message>
        <source>Area where a trained hand can feel it [cm²]</source>
        <translation>Aire où une main exercée le sent [cm²]</translation>
    </message>
    <message>
        <source>Pressed hard enough [%]</source>
        <translation>Assez appuyé [%]</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>Nodules</translation>
    </message>
    <message>
        <source>Lumps were not evaluated, because the scene is missing.</source>
        <translation>Les nodules n’ont pas été évalués, car la scène manque.</translation>
    </message>
    <message>
        <source>No lump in an organ could be evaluated.</source>
        <translation>Aucun nodule dans un organe n’a pu être évalué.</translation>
    </message>
    <message>
        <source>ball of %1 mm radius</source>
        <translation>boule de %1 mm de rayon</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>Device and recording conditions</source>
        <translation>Appareil et conditions d’enregistrement</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Force limit of the device</source>
        <translation>Limite de force de l’appareil</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Ticks</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Ticks en retard</translation>
    </message>
    <message>
        <source>Lost ticks</source>
        <translation>Ticks perdus</translation>
    </message>
    <message>
        <source>Fingertip</source>
        <translation>Bout du doigt</translation>
    </message>
    <message>
        <source>Distance that counts as touched</source>
        <translation>Distance comptée comme touchée</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>nonlinear</source>
        <translation>non linéaire</translation>
    </message>
    <message>
        <source>with friction</source>
        <translation>avec frottement</translation>
    </message>
    <message>
        <source>with maps or motion</source>
        <translation>avec cartes ou mouvement</translation>
    </message>
    <message>
        <source>Tissue at the start of the recording</source>
        <translation>Tissu au début de l’enregistrement</translation>
    </message>
    <message>
        <source>Stiffness [N/mm]</source>
        <translation>Raideur [N/mm]</translation>
    </message>
    <message>
        <source>Damping [N·s/mm]</source>
        <translation>Amortissement [N·s/mm]</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Loi de force</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Couche</translation>
    </message>
    <message>
        <source>Own surface palpable</source>
        <translation>Surface propre palpable</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Not computed again: %1.</source>
        <translation>Pas recalculé&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. Every position and force is the same, bit for bit.</source>
        <translation>Ticks recalculés&#x202f;: %1. Toutes les positions et forces sont identiques bit à bit.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. Of these, %2 differ by rounding: by at most %3 mm and %4 N.</source>
        <translation>Ticks recalculés&#x202f;: %1. Parmi eux, %2 diffèrent par arrondi&#x202f;: d’au plus %3 mm et %4 N.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. The forces differ by more than rounding: %2.</source>
        <translation>Ticks recalculés&#x202f;: %1. Les forces diffèrent de plus que l’arrondi&#x202f;: %2.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>SHA-256 of the scene</source>
        <translation>SHA-256 de la scène</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Enregistré avec</translation>
    </message>
    <message>
        <source>Palpate %1 (%2)</source>
        <translation>Palpate %1 (%2)</translation>
    </message>
    <message>
        <source>Report made by</source>
        <translation>Rapport établi avec</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>SHA-256 of the geometry, as palpated</source>
        <translation>SHA-256 de la géométrie, telle que palpée</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>A hand with a haptic device, a mouse or a script palpated surface models of segmented anatomy. Forces are those of the model before any limit of the device; depths are distances between the hand and the surface. Positions and lengths are in mm in the frame LPS (x to the patient&apos;s left, y to the back, z to the head). Surfaces, and therefore distances, are as uncertain as the segmentation, about one voxel.</source>
        <translation>Une main avec un appareil haptique, une souris ou un script a palpé des modèles de surface d’une anatomie segmentée. Les forces sont celles du modèle avant toute limite de l’appareil&#x202f;; les profondeurs sont des distances entre la main et la surface. Positions et longueurs sont en mm dans le repère LPS (x vers la gauche du patient, y vers le dos, z vers la tête). Les surfaces, donc les distances, sont aussi incertaines que la segmentation, environ un voxel.</translation>
    </message>
    <message>
        <source>The recording describes no scene.</source>
        <translation>L’enregistrement ne décrit aucune scène.</translation>
    </message>
    <message>
        <source>Data and verification</source>
        <translation>Données et vérification</translation>
    </message>
    <message>
        <source>Database intact, checksums of %1 ticks correct.</source>
        <translation>Base de données intacte, sommes de contrôle de %1 ticks correctes.</translation>
    </message>
    <message>
        <source>Damaged, or changed after it was recorded: %1.</source>
        <translation>Endommagé, ou modifié après l’enregistrement&#x202f;: %1.</translation>
    </message>
    <message>
        <source>More damaged places: %1.</source>
        <translation>Autres endroits endommagés&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1: found another extension, expected a name that ends in .pdf or .html</source>
        <translation>%1&#x202f;: autre extension trouvée, un nom finissant par .pdf ou .html était attendu</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>found no display with OpenGL to draw them; app/run.sh draws without a display</source>
        <translation>aucun affichage avec OpenGL trouvé pour les dessiner&#x202f;; app/run.sh dessine sans affichage</translation>
    </message>
    <message>
        <source>the surface of %1 is another one</source>
        <translation>la surface de %1 est une autre</translation>
    </message>
    <message>
        <source>%1 was palpable only in the first</source>
        <translation>%1 n’était palpable que dans le premier</translation>
    </message>
    <message>
        <source>%1 was palpable only in the second</source>
        <translation>%1 n’était palpable que dans le second</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Median force [N]</source>
        <translation>Force médiane [N]</translation>
    </message>
    <message>
        <source>95th percentile of the force [N]</source>
        <translation>95e percentile de la force [N]</translation>
    </message>
    <message>
        <source>Mean depth [mm]</source>
        <translation>Profondeur moyenne [mm]</translation>
    </message>
    <message>
        <source>Searching [s]</source>
        <translation>Recherche [s]</translation>
    </message>
    <message>
        <source>Mean force when searching [N]</source>
        <translation>Force moyenne en cherchant [N]</translation>
    </message>
    <message>
        <source>Pressing [s]</source>
        <translation>Appui [s]</translation>
    </message>
    <message>
        <source>Mean force when pressing [N]</source>
        <translation>Force moyenne en appuyant [N]</translation>
    </message>
    <message>
        <source>Duration [s]</source>
        <translation>Durée [s]</translation>
    </message>
    <message>
        <source>Path of the hand [mm]</source>
        <translation>Trajet de la main [mm]</translation>
    </message>
    <message>
        <source>Path on the surface [mm]</source>
        <translation>Trajet sur la surface [mm]</translation>
    </message>
    <message>
        <source>Marked findings</source>
        <translation>Constatations marquées</translation>
    </message>
    <message>
        <source>Largest recorded change [%]</source>
        <translation>Plus grand changement enregistré [%]</translation>
    </message>
    <message>
        <source>%1 and %2: found recordings of different surfaces (%3), expected two recordings of the same scene</source>
        <translation>%1 et %2&#x202f;: trouvé des enregistrements de surfaces différentes (%3), attendu deux enregistrements de la même scène</translation>
    </message>
    <message>
        <source>the check was cancelled</source>
        <translation>la vérification a été annulée</translation>
    </message>
    <message>
        <source>%1: found the same recording twice, expected two</source>
        <translation>%1&#x202f;: trouvé deux fois le même enregistrement, attendu deux enregistrements</translation>
    </message>
    <message>
        <source>No coverage: %1.</source>
        <translation>Pas de couverture&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The fingertip was a ball of %1 mm radius in A and %2 mm in B (0: a point).</source>
        <translation>Le bout du doigt était une bille de %1 mm de rayon dans A et de %2 mm dans B (0&#x202f;: un point).</translation>
    </message>
    <message>
        <source>The device was %1 in A and %2 in B.</source>
        <translation>L’appareil était %1 dans A et %2 dans B.</translation>
    </message>
    <message>
        <source>The stiffness of %1 was %2 N/mm in A and %3 N/mm in B.</source>
        <translation>La raideur de %1 était de %2 N/mm dans A et de %3 N/mm dans B.</translation>
    </message>
    <message>
        <source>The tissue of %1 was not the same in A and B.</source>
        <translation>Le tissu de %1 n’était pas le même dans A et B.</translation>
    </message>
    <message>
        <source>%1 is damaged, or was changed after it was made. Damaged places: %2. Ticks that do not match their checksum are left out of all numbers.</source>
        <translation>%1 est endommagé ou a été modifié après sa création. Endroits endommagés&#x202f;: %2. Les pas qui ne correspondent pas à leur somme de contrôle sont exclus de tous les chiffres.</translation>
    </message>
    <message>
        <source>noticeable</source>
        <translation>perceptible</translation>
    </message>
    <message>
        <source>not noticeable</source>
        <translation>imperceptible</translation>
    </message>
    <message>
        <source>Search for %1</source>
        <translation>Recherche de %1</translation>
    </message>
    <message>
        <source>Contact with %1</source>
        <translation>Contact avec %1</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Relative to A</source>
        <translation>Par rapport à A</translation>
    </message>
    <message>
        <source>By hand (7 %)</source>
        <translation>À la main (7 %)</translation>
    </message>
    <message>
        <source>Touched surface, within %1 mm of the contact</source>
        <translation>Surface touchée, à moins de %1 mm du contact</translation>
    </message>
    <message>
        <source>Both [cm²]</source>
        <translation>Les deux [cm²]</translation>
    </message>
    <message>
        <source>Only A [cm²]</source>
        <translation>A seul [cm²]</translation>
    </message>
    <message>
        <source>Only B [cm²]</source>
        <translation>B seul [cm²]</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Time spent, s</source>
        <translation>Temps passé, s</translation>
    </message>
    <message>
        <source>Largest force, N</source>
        <translation>Force maximale, N</translation>
    </message>
    <message>
        <source>touched: %1</source>
        <translation>touché&#x202f;: %1</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>au-dessus de %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Map of touch</source>
        <translation>Carte du toucher</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>de face</translation>
    </message>
    <message>
        <source>from the patient&apos;s left</source>
        <translation>de la gauche du patient</translation>
    </message>
    <message>
        <source>Map of touch %1. %2, colours up to %3; %4.</source>
        <translation>Carte du toucher %1. %2, couleurs jusqu’à %3&#x202f;; %4.</translation>
    </message>
    <message>
        <source>The brighter a place, the longer or more firmly the contact came within %1 mm. Places in the colour of the structure were not touched. Shares refer to the surfaces of the touched structures, which are drawn opaque. The colours end at the 98th percentile, rounded up.</source>
        <translation>Plus un endroit est clair, plus le contact à moins de %1 mm a été long ou ferme. Les endroits de la couleur de la structure n’ont pas été touchés. Les parts se rapportent aux surfaces des structures touchées, dessinées opaques. Les couleurs finissent au 98e percentile, arrondi vers le haut.</translation>
    </message>
    <message>
        <source>forcedimension: the device with serial number %1 could not be opened: %2</source>
        <translation>forcedimension&#x202f;: impossible d’ouvrir l’appareil de numéro de série %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>forcedimension: no device is connected: plug it in, switch it on, and install Palpate&apos;s udev rule (in lib/udev/rules.d)</source>
        <translation>forcedimension&#x202f;: aucun appareil n’est branché&#x202f;: branchez-le, allumez-le et installez la règle udev de Palpate (dans lib/udev/rules.d)</translation>
    </message>
    <message>
        <source>forcedimension: %1 devices are connected, expected one: choose by &quot;serial&quot; in ~/.config/Palpate/forcedimension.json; &quot;palpate devices&quot; lists the serial numbers</source>
        <translation>forcedimension&#x202f;: %1 appareils sont branchés, un seul est attendu&#x202f;: choisissez avec «&#x202f;serial&#x202f;» dans ~/.config/Palpate/forcedimension.json&#x202f;; «&#x202f;palpate devices&#x202f;» affiche les numéros de série</translation>
    </message>
    <message>
        <source>forcedimension: the device could not be opened: %1</source>
        <translation>forcedimension&#x202f;: impossible d’ouvrir l’appareil&#x202f;: %1</translation>
    </message>
    <message>
        <source>forcedimension: the device is already in use by this program</source>
        <translation>forcedimension&#x202f;: l’appareil est déjà utilisé par ce programme</translation>
    </message>
    <message>
        <source>forcedimension: found the serial number %1, expected %2; plug the device in again</source>
        <translation>forcedimension&#x202f;: numéro de série %1 trouvé, %2 attendu&#x202f;; rebranchez l’appareil</translation>
    </message>
    <message>
        <source>install the Force Dimension SDK 3 of the maker, or set &quot;library&quot; in ~/.config/Palpate/forcedimension.json to the path of libdhd.so.3</source>
        <translation>installez le SDK 3 de Force Dimension du fabricant, ou indiquez dans «&#x202f;library&#x202f;» de ~/.config/Palpate/forcedimension.json le chemin de libdhd.so.3</translation>
    </message>
    <message>
        <source>it is not free: close other programs that use it</source>
        <translation>il n’est pas libre&#x202f;: fermez les autres programmes qui l’utilisent</translation>
    </message>
    <message>
        <source>access is refused: install Palpate&apos;s udev rule (in lib/udev/rules.d) and plug the device in again</source>
        <translation>accès refusé&#x202f;: installez la règle udev de Palpate (dans lib/udev/rules.d) et rebranchez l’appareil</translation>
    </message>
    <message>
        <source>it is not connected: plug it in and switch it on</source>
        <translation>il n’est pas branché&#x202f;: branchez-le et allumez-le</translation>
    </message>
    <message>
        <source>forcedimension: the device was opened but gives no position; switch it off and on</source>
        <translation>forcedimension&#x202f;: l’appareil est ouvert mais ne donne pas de position&#x202f;; éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>This device is calibrated at the device: put the end of its handle into the calibration pit and hold it there until its light is steady.</source>
        <translation>Cet appareil s’étalonne sur l’appareil même&#x202f;: placez l’extrémité de la poignée dans le creux d’étalonnage et maintenez-la jusqu’à ce que le voyant soit fixe.</translation>
    </message>
    <message>
        <source>forcedimension: found the address &quot;%1&quot;, expected a serial number</source>
        <translation>forcedimension&#x202f;: adresse «&#x202f;%1&#x202f;» trouvée, un numéro de série est attendu</translation>
    </message>
    <message>
        <source>%1: expected an object, as %2</source>
        <translation>%1&#x202f;: attendu un objet, comme %2</translation>
    </message>
    <message>
        <source>%1: %2 could not be loaded (%3); %4</source>
        <translation>%1&#x202f;: impossible de charger %2 (%3)&#x202f;; %4</translation>
    </message>
    <message>
        <source>%1: the library &quot;%2&quot; in the settings is a relative path, expected one that begins with /</source>
        <translation>%1&#x202f;: la bibliothèque «&#x202f;%2&#x202f;» des réglages est un chemin relatif, un chemin commençant par / est attendu</translation>
    </message>
    <message>
        <source>%1: %2, the library in the settings, was not found; %3</source>
        <translation>%1&#x202f;: %2, la bibliothèque indiquée dans les réglages, est introuvable&#x202f;; %3</translation>
    </message>
    <message>
        <source>%1: %2 was not found; %3</source>
        <translation>%1&#x202f;: %2 est introuvable&#x202f;; %3</translation>
    </message>
    <message>
        <source>%1: %2 lacks %3 of the needed functions, the first is %4: another version of the library; %5</source>
        <translation>%1&#x202f;: il manque à %2 %3 des fonctions nécessaires, la première est %4&#x202f;: autre version de la bibliothèque&#x202f;; %5</translation>
    </message>
    <message>
        <source>%1: %2 is version %3, expected version %4; %5</source>
        <translation>%1&#x202f;: %2 est en version %3, version %4 attendue&#x202f;; %5</translation>
    </message>
    <message>
        <source>%1: found no scene file with an exercise; say where it is with --scene</source>
        <translation>%1&#x202f;: aucun fichier de scène avec un exercice&#x202f;; indiquez son emplacement avec --scene</translation>
    </message>
    <message>
        <source>%1: exercise: found nothing, expected the targets of an exercise</source>
        <translation>%1&#x202f;: exercise&#x202f;: rien trouvé, attendu les cibles d’un exercice</translation>
    </message>
    <message>
        <source>%1: no coverage of %2: its surface is missing or another one now; say where the scene is with --scene</source>
        <translation>%1&#x202f;: pas de couverture de %2&#x202f;: sa surface manque ou a changé&#x202f;; indiquez l’emplacement de la scène avec --scene</translation>
    </message>
    <message>
        <source>(%1, %2, %3) mm</source>
        <translation>(%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>no position that the field maps to this one: it may fold</source>
        <translation>aucune position que le champ envoie sur celle-ci&#x202f;: il se replie peut-être</translation>
    </message>
    <message>
        <source>a field that can be inverted; is its direction right?</source>
        <translation>un champ inversible&#x202f;; sa direction est-elle correcte&#x202f;?</translation>
    </message>
    <message>
        <source>outside of the field</source>
        <translation>hors du champ</translation>
    </message>
    <message>
        <source>a field that covers the structure, at rest and moved, in the same coordinates</source>
        <translation>un champ qui couvre la structure, au repos et déplacée, dans les mêmes coordonnées</translation>
    </message>
    <message>
        <source>the path of at least one displacement field</source>
        <translation>le chemin d’au moins un champ de déplacement</translation>
    </message>
    <message>
        <source>an unknown format</source>
        <translation>un format inconnu</translation>
    </message>
    <message>
        <source>a displacement field as .nrrd, .mha or .nii</source>
        <translation>un champ de déplacement en .nrrd, .mha ou .nii</translation>
    </message>
    <message>
        <source>a displacement field with 3</source>
        <translation>un champ de déplacement avec 3</translation>
    </message>
    <message>
        <source>3 numbers per voxel that are not marked as a vector</source>
        <translation>3 nombres par voxel qui ne sont pas marqués comme un vecteur</translation>
    </message>
    <message>
        <source>a displacement field: the kind &quot;vector&quot; (NRRD), 3 channels (MetaImage) or the intent 1006 or 1007 (NIfTI)</source>
        <translation>un champ de déplacement&#x202f;: le type &quot;vector&quot; (NRRD), 3 canaux (MetaImage) ou l’intention 1006 ou 1007 (NIfTI)</translation>
    </message>
    <message>
        <source>directions that are not finite numbers</source>
        <translation>des directions qui ne sont pas des nombres finis</translation>
    </message>
    <message>
        <source>three vectors of three numbers</source>
        <translation>trois vecteurs de trois nombres</translation>
    </message>
    <message>
        <source>neither sform nor qform</source>
        <translation>ni sform ni qform</translation>
    </message>
    <message>
        <source>the position of its voxels</source>
        <translation>la position de ses voxels</translation>
    </message>
    <message>
        <source>voxel (%1, %2, %3)</source>
        <translation>voxel (%1, %2, %3)</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>un nombre qui n’est pas fini</translation>
    </message>
    <message>
        <source>a displacement in mm</source>
        <translation>un déplacement en mm</translation>
    </message>
    <message>
        <source>the name of at least one structure of this scene</source>
        <translation>le nom d’au moins une structure de cette scène</translation>
    </message>
    <message>
        <source>%1, the name of several structures</source>
        <translation>%1, le nom de plusieurs structures</translation>
    </message>
    <message>
        <source>%1, which is not palpable</source>
        <translation>%1, qui n’est pas palpable</translation>
    </message>
    <message>
        <source>a structure that can be felt</source>
        <translation>une structure palpable</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>chaque cible une seule fois</translation>
    </message>
    <message>
        <source>target %1: its surface is missing or another one now; say where the scene is with --scene</source>
        <translation>cible %1&#x202f;: sa surface manque ou a changé&#x202f;; indiquez l’emplacement de la scène avec --scene</translation>
    </message>
    <message>
        <source>target %1: found no structure of that name in the recording, expected the scene that it was made on</source>
        <translation>cible %1&#x202f;: aucune structure de ce nom dans l’enregistrement, attendu&#x202f;: la scène de l’enregistrement</translation>
    </message>
    <message>
        <source>trials: found %1, expected 1 to %2</source>
        <translation>essais&#x202f;: %1 trouvé, attendu 1 à %2</translation>
    </message>
    <message>
        <source>places: found %1, expected 2 to %2</source>
        <translation>endroits&#x202f;: %1 trouvé, attendu 2 à %2</translation>
    </message>
    <message>
        <source>first change: found %1 %, expected %2 to %3 %</source>
        <translation>premier changement&#x202f;: %1&#x202f;% trouvé, attendu %2 à %3&#x202f;%</translation>
    </message>
    <message>
        <source>an origin that is too far away</source>
        <translation>une origine trop éloignée</translation>
    </message>
    <message>
        <source>positions in mm</source>
        <translation>des positions en mm</translation>
    </message>
    <message>
        <source>nothing written: found no recording that can be measured, expected at least one</source>
        <translation>rien n’a été écrit&#x202f;: aucun enregistrement mesurable trouvé, au moins un était attendu</translation>
    </message>
    <message>
        <source>session measure: found several recordings or a folder, expected --csv or --findings for their tables</source>
        <translation>session measure&#x202f;: plusieurs enregistrements ou un dossier trouvés, --csv ou --findings attendu pour leurs tableaux</translation>
    </message>
    <message>
        <source>session measure: found --json with --csv or --findings, expected one form</source>
        <translation>session measure&#x202f;: --json trouvé avec --csv ou --findings, une seule forme attendue</translation>
    </message>
    <message>
        <source>--columns: found no --csv, expected the file with these columns</source>
        <translation>--columns&#x202f;: aucun --csv trouvé, le fichier de ces colonnes était attendu</translation>
    </message>
    <message>
        <source>%1: found no visible surface, expected one to draw</source>
        <translation>%1&#x202f;: aucune surface visible trouvée, il en faut une à dessiner</translation>
    </message>
    <message>
        <source>%1: found %2 bytes, expected %3</source>
        <translation>%1&#x202f;: %2 octets trouvés, %3 attendus</translation>
    </message>
    <message>
        <source>POSITION: expected finite numbers within 1,000,000 mm and a unit quaternion</source>
        <translation>POSITION&#x202f;: nombres finis jusqu’à 1 000 000 mm et quaternion unitaire attendus</translation>
    </message>
    <message>
        <source>TDATA: found %1 bytes, expected a multiple of %2</source>
        <translation>TDATA&#x202f;: %1 octets trouvés, multiple de %2 attendu</translation>
    </message>
    <message>
        <source>found the host %1, expected localhost or a numeric address such as 192.168.0.10</source>
        <translation>hôte %1 trouvé, localhost ou une adresse numérique telle que 192.168.0.10 attendu</translation>
    </message>
    <message>
        <source>nothing answers at %1, port %2: %3</source>
        <translation>aucune réponse de %1, port %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>found the address %1, expected a numeric address such as 127.0.0.1</source>
        <translation>adresse %1 trouvée, adresse numérique telle que 127.0.0.1 attendue</translation>
    </message>
    <message>
        <source>Port %1 is used by another program, perhaps a second Palpate. Choose another port.</source>
        <translation>Le port %1 est utilisé par un autre programme, peut-être un second Palpate. Choisissez un autre port.</translation>
    </message>
    <message>
        <source>%1, port %2: %3</source>
        <translation>%1, port %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>POLYDATA: %1: found %2 bytes for %3 cells</source>
        <translation>POLYDATA&#x202f;: %1&#x202f;: %2 octets trouvés pour %3 cellules</translation>
    </message>
    <message>
        <source>POLYDATA: %1: cell %2 has point %3, expected less than %4</source>
        <translation>POLYDATA&#x202f;: %1&#x202f;: la cellule %2 a le point %3, moins de %4 attendu</translation>
    </message>
    <message>
        <source>POLYDATA: point %1: expected numbers within 1,000,000 mm</source>
        <translation>POLYDATA&#x202f;: point %1&#x202f;: nombres jusqu’à 1 000 000 mm attendus</translation>
    </message>
    <message>
        <source>POLYDATA: found no triangle</source>
        <translation>POLYDATA&#x202f;: aucun triangle trouvé</translation>
    </message>
    <message>
        <source>no direction</source>
        <translation>aucune direction</translation>
    </message>
    <message>
        <source>three numbers that point to the hidden side</source>
        <translation>trois nombres dirigés vers le côté caché</translation>
    </message>
    <message>
        <source>%1; copy the readable parts with `palpate session recover` first, then share the copy</source>
        <translation>%1&#x202f;; copiez d’abord les parties lisibles avec `palpate session recover`, puis partagez cette copie</translation>
    </message>
    <message>
        <source>--columns: found &quot;%1&quot;, expected some of %2</source>
        <translation>--columns&#x202f;: «&#x202f;%1&#x202f;» trouvé, un choix parmi %2 attendu</translation>
    </message>
    <message>
        <source>--columns: found &quot;%1&quot; twice, expected each column once</source>
        <translation>--columns&#x202f;: «&#x202f;%1&#x202f;» trouvé deux fois, chaque colonne attendue une fois</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trouvée</translation>
    </message>
    <message>
        <source>found before</source>
        <translation>déjà trouvée</translation>
    </message>
    <message>
        <source>false alarm</source>
        <translation>fausse alerte</translation>
    </message>
    <message>
        <source>after the time limit, not counted</source>
        <translation>après la limite de temps, non compté</translation>
    </message>
    <message>
        <source>not counted: a landmark or a place to keep away from</source>
        <translation>non compté&#x202f;: un repère ou un endroit à éviter</translation>
    </message>
    <message>
        <source>Examinee</source>
        <translation>Candidat</translation>
    </message>
    <message>
        <source>Targets found: %1 of %2. Missed: %3. False alarms: %4.</source>
        <translation>Cibles trouvées&#x202f;: %1 sur %2. Manquées&#x202f;: %3. Fausses alertes&#x202f;: %4.</translation>
    </message>
    <message>
        <source>No coverage of %1: its surface is missing or another one now.</source>
        <translation>Pas de couverture de %1&#x202f;: sa surface manque ou a changé.</translation>
    </message>
    <message>
        <source>Ticks lost while recording: %1.</source>
        <translation>Pas perdus pendant l’enregistrement&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
    <message>
        <source>A target is found by a finding within %1 mm of the ball around it</source>
        <translation>Une cible est trouvée par une observation à moins de %1 mm de la sphère qui l’entoure</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Found after [s]</source>
        <translation>Trouvée après [s]</translation>
    </message>
    <message>
        <source>Distance from the ball [mm]</source>
        <translation>Distance à la sphère [mm]</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>manquée</translation>
    </message>
    <message>
        <source>Findings as they were at the end of the recording</source>
        <translation>Observations telles qu’elles étaient à la fin de l’enregistrement</translation>
    </message>
    <message>
        <source>Search and force</source>
        <translation>Recherche et force</translation>
    </message>
    <message>
        <source>Time limit [s]</source>
        <translation>Limite de temps [s]</translation>
    </message>
    <message>
        <source>Searched share of the surface [%]</source>
        <translation>Part explorée de la surface [%]</translation>
    </message>
    <message>
        <source>Surface to be searched [cm²]</source>
        <translation>Surface à explorer [cm²]</translation>
    </message>
    <message>
        <source>Distance that counts as touched [mm]</source>
        <translation>Distance comptée comme touchée [mm]</translation>
    </message>
    <message>
        <source>Goal of the exercise [%]</source>
        <translation>But de l’exercice [%]</translation>
    </message>
    <message>
        <source>Force ceiling [N]</source>
        <translation>Plafond de force [N]</translation>
    </message>
    <message>
        <source>Time above the ceiling [s]</source>
        <translation>Temps au-dessus du plafond [s]</translation>
    </message>
    <message>
        <source>Impulse above the ceiling [N s]</source>
        <translation>Impulsion au-dessus du plafond [N s]</translation>
    </message>
    <message>
        <source>Search exercise</source>
        <translation>Exercice de recherche</translation>
    </message>
    <message>
        <source>The targets, as seen at the end of the exercise</source>
        <translation>Les cibles, telles que vues à la fin de l’exercice</translation>
    </message>
    <message>
        <source>The scene with a ring above each target and the findings as numbered discs.</source>
        <translation>La scène avec un anneau au-dessus de chaque cible et les observations en disques numérotés.</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Endroits</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Définitions</translation>
    </message>
    <message>
        <source>The ball around a target has its centre in the centroid of the surface and reaches to the farthest vertex. Landmarks and places to keep away from do not count. Times are counted from the first tick of the recording. The same numbers are printed by: palpate session exercise. No grade is given.</source>
        <translation>La sphère autour d’une cible a son centre au centroïde de la surface et va jusqu’au sommet le plus éloigné. Les repères et les endroits à éviter ne comptent pas. Les temps sont comptés depuis le premier pas de l’enregistrement. Les mêmes nombres sont affichés par&#x202f;: palpate session exercise. Aucune note n’est donnée.</translation>
    </message>
    <message>
        <source>%1: found no recording, expected files named *.palpate</source>
        <translation>%1&#x202f;: aucun enregistrement trouvé, des fichiers nommés *.palpate étaient attendus</translation>
    </message>
    <message>
        <source>%1: the folder cannot be read: %2</source>
        <translation>%1&#x202f;: le dossier ne peut pas être lu&#x202f;: %2</translation>
    </message>
    <message>
        <source>stop the recording first</source>
        <translation>arrêtez d’abord l’enregistrement</translation>
    </message>
    <message>
        <source>This device is calibrated by its maker&apos;s service: attach its grip, and calibrate it as Haply Hub shows.</source>
        <translation>Cet appareil est étalonné par le service de son fabricant&#x202f;: fixez sa poignée et étalonnez-le comme l’indique Haply Hub.</translation>
    </message>
    <message>
        <source>haply: found version %1.%2 of the Inverse Service, expected 3.1 to 3.x; install version 3.5 with Haply Hub</source>
        <translation>haply&#x202f;: la version %1.%2 de l’Inverse Service a été trouvée, 3.1 à 3.x était attendue&#x202f;; installez la version 3.5 avec Haply Hub</translation>
    </message>
    <message>
        <source>haply: the program at port %1 sends no list of devices as the Inverse Service does; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply&#x202f;: le programme au port %1 n’envoie pas de liste d’appareils comme l’Inverse Service&#x202f;; donnez à «&#x202f;port&#x202f;» dans ~/.config/Palpate/haply.json le port WebSocket du service</translation>
    </message>
    <message>
        <source>haply: the Inverse Service has no device: connect its USB cable and its power supply, and switch it on</source>
        <translation>haply&#x202f;: l’Inverse Service n’a pas d’appareil&#x202f;: branchez son câble USB et son alimentation, et allumez-le</translation>
    </message>
    <message>
        <source>haply: %1 devices are connected, expected one: choose by &quot;device_id&quot; in ~/.config/Palpate/haply.json; &quot;palpate devices&quot; lists the identifiers</source>
        <translation>haply&#x202f;: %1 appareils sont branchés, un seul était attendu&#x202f;: choisissez par «&#x202f;device_id&#x202f;» dans ~/.config/Palpate/haply.json&#x202f;; «&#x202f;palpate devices&#x202f;» donne les identifiants</translation>
    </message>
    <message>
        <source>haply: found no device %1, but %2; &quot;palpate devices&quot; lists the identifiers</source>
        <translation>haply&#x202f;: l’appareil %1 n’a pas été trouvé, mais %2&#x202f;; «&#x202f;palpate devices&#x202f;» donne les identifiants</translation>
    </message>
    <message>
        <source>haply: the device %1 is already in use by this program</source>
        <translation>haply&#x202f;: l’appareil %1 est déjà utilisé par ce programme</translation>
    </message>
    <message>
        <source>%1: %2: expected an identifier in quotes, as &quot;049D&quot;</source>
        <translation>%1&#x202f;: %2&#x202f;: un identifiant entre guillemets était attendu, comme &quot;049D&quot;</translation>
    </message>
    <message>
        <source>haply: the Inverse Service does not answer at port %1: install it, or start it with Haply Hub or &quot;sudo systemctl start haply-inverse-service&quot;</source>
        <translation>haply&#x202f;: l’Inverse Service ne répond pas au port %1&#x202f;: installez-le, ou démarrez-le avec Haply Hub ou «&#x202f;sudo systemctl start haply-inverse-service&#x202f;»</translation>
    </message>
    <message>
        <source>haply: found a program at port %1 that does not answer like the Inverse Service; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply&#x202f;: le programme au port %1 ne répond pas comme l’Inverse Service&#x202f;; donnez à «&#x202f;port&#x202f;» dans ~/.config/Palpate/haply.json le port WebSocket du service</translation>
    </message>
    <message>
        <source>haply: found &quot;%1&quot; at port %2, expected a WebSocket; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply&#x202f;: «&#x202f;%1&#x202f;» a été trouvé au port %2, un WebSocket était attendu&#x202f;; donnez à «&#x202f;port&#x202f;» dans ~/.config/Palpate/haply.json le port WebSocket du service</translation>
    </message>
    <message>
        <source>The device is not connected.</source>
        <translation>L’appareil n’est pas connecté.</translation>
    </message>
    <message>
        <source>This device is calibrated in its inkwell: put the stylus into it, wait two seconds, and take it out.</source>
        <translation>Cet appareil s’étalonne dans son encrier&#x202f;: placez-y le stylet, attendez deux secondes et retirez-le.</translation>
    </message>
    <message>
        <source>install OpenHaptics and the Touch driver of 3D Systems, or set &quot;library&quot; in ~/.config/Palpate/openhaptics.json to the path of libHD.so.3.4; see the page &quot;devices&quot; of the documentation</source>
        <translation>installez OpenHaptics et le pilote Touch de 3D Systems, ou donnez à «&#x202f;library&#x202f;» dans ~/.config/Palpate/openhaptics.json le chemin de libHD.so.3.4&#x202f;; voir la page «&#x202f;devices&#x202f;» de la documentation</translation>
    </message>
    <message>
        <source>openhaptics: libHD is version %1, expected version 3; %2</source>
        <translation>openhaptics&#x202f;: libHD est en version %1, la version 3 était attendue&#x202f;; %2</translation>
    </message>
    <message>
        <source>the licence of OpenHaptics is missing or has expired: install the licence with the maker&apos;s tools</source>
        <translation>la licence d’OpenHaptics manque ou a expiré&#x202f;: installez-la avec les outils du fabricant</translation>
    </message>
    <message>
        <source>it does not answer: connect its cable and its power supply, install Palpate&apos;s udev rule (in lib/udev/rules.d), and plug it in again</source>
        <translation>il ne répond pas&#x202f;: branchez son câble et son alimentation, installez la règle udev de Palpate (dans lib/udev/rules.d) et rebranchez-le</translation>
    </message>
    <message>
        <source>its configuration does not fit: run the maker&apos;s Touch_Setup; configurations are read from %1</source>
        <translation>sa configuration ne convient pas&#x202f;: lancez Touch_Setup du fabricant&#x202f;; les configurations sont lues dans %1</translation>
    </message>
    <message>
        <source>it reports a fault: disconnect its power supply, wait five seconds, and connect it again</source>
        <translation>il signale une panne&#x202f;: débranchez son alimentation, attendez cinq secondes et rebranchez-la</translation>
    </message>
    <message>
        <source>error %1 of libHD (%2): run the maker&apos;s Touch_Diagnostic; configurations are read from %3</source>
        <translation>erreur %1 de libHD (%2)&#x202f;: lancez Touch_Diagnostic du fabricant&#x202f;; les configurations sont lues dans %3</translation>
    </message>
    <message>
        <source>%1: the device is already in use by this program</source>
        <translation>%1&#x202f;: l’appareil est déjà utilisé par ce programme</translation>
    </message>
    <message>
        <source>openhaptics: libHD does not answer: switch the device off and on, and start Palpate again</source>
        <translation>openhaptics&#x202f;: libHD ne répond pas&#x202f;: éteignez et rallumez l’appareil, puis relancez Palpate</translation>
    </message>
    <message>
        <source>openhaptics: %1 devices are configured, expected one: choose by &quot;device&quot; in ~/.config/Palpate/openhaptics.json; &quot;palpate devices&quot; lists the names and the serial numbers</source>
        <translation>openhaptics&#x202f;: %1 appareils sont configurés, un seul était attendu&#x202f;: choisissez par «&#x202f;device&#x202f;» dans ~/.config/Palpate/openhaptics.json&#x202f;; «&#x202f;palpate devices&#x202f;» liste les noms et les numéros de série</translation>
    </message>
    <message>
        <source>openhaptics: no device has the name or the serial number &quot;%1&quot;: run the maker&apos;s Touch_Setup; configurations are read from %2</source>
        <translation>openhaptics&#x202f;: aucun appareil n’a le nom ou le numéro de série «&#x202f;%1&#x202f;»&#x202f;: lancez Touch_Setup du fabricant&#x202f;; les configurations sont lues dans %2</translation>
    </message>
    <message>
        <source>openhaptics: the device &quot;%1&quot; could not be opened: %2</source>
        <translation>openhaptics&#x202f;: impossible d’ouvrir l’appareil «&#x202f;%1&#x202f;»&#x202f;: %2</translation>
    </message>
    <message>
        <source>openhaptics: %1 devices are in use, no more are possible</source>
        <translation>openhaptics&#x202f;: %1 appareils sont utilisés, le maximum possible</translation>
    </message>
    <message>
        <source>openhaptics: the device was opened but gives no position; switch it off and on</source>
        <translation>openhaptics&#x202f;: l’appareil a été ouvert mais ne donne aucune position&#x202f;; éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>%1: device: expected the name of a configuration, or a serial number, in quotes</source>
        <translation>%1&#x202f;: device&#x202f;: le nom d’une configuration ou un numéro de série, entre guillemets, était attendu</translation>
    </message>
    <message>
        <source>%1. Start the server there, or set host and port in openigtlink.json.</source>
        <translation>%1. Démarrez-y le serveur, ou indiquez host et port dans openigtlink.json.</translation>
    </message>
    <message>
        <source>The positions are those of the scene, so there is no centre to set. With workspace_radius_mm in openigtlink.json, the current position becomes the centre.</source>
        <translation>Les positions sont celles de la scène, il n’y a donc pas de centre à définir. Avec workspace_radius_mm dans openigtlink.json, la position actuelle devient le centre.</translation>
    </message>
    <message>
        <source>%1: found a matrix that is singular, scaled, mirrored or out of reach, expected a rotation and a position in mm</source>
        <translation>%1&#x202f;: matrice singulière, mise à l’échelle, inversée ou trop éloignée trouvée, rotation et position en mm attendues</translation>
    </message>
    <message>
        <source>%1: %2: expected a text of at most %3 bytes in quotes</source>
        <translation>%1&#x202f;: %2&#x202f;: texte d’au plus %3 octets entre guillemets attendu</translation>
    </message>
    <message>
        <source>%1: %2: found &quot;%3&quot;, expected &quot;RAS&quot; or &quot;LPS&quot;</source>
        <translation>%1&#x202f;: %2&#x202f;: «&#x202f;%3&#x202f;» trouvé, «&#x202f;RAS&#x202f;» ou «&#x202f;LPS&#x202f;» attendu</translation>
    </message>
    <message>
        <source>%1: library: expected the path of %2 in quotes</source>
        <translation>%1&#x202f;: library&#x202f;: le chemin de %2 entre guillemets était attendu</translation>
    </message>
    <message>
        <source>--check: found &quot;%1&quot;, expected one of %2</source>
        <translation>--check&#x202f;: «&#x202f;%1&#x202f;» trouvé, l’un des suivants est attendu&#x202f;: %2</translation>
    </message>
    <message>
        <source>the device reports: %1</source>
        <translation>l’appareil signale&#x202f;: %1</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>vers la droite</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>vers la gauche</translation>
    </message>
    <message>
        <source>up</source>
        <translation>vers le haut</translation>
    </message>
    <message>
        <source>down</source>
        <translation>vers le bas</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>vers vous</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>en s’éloignant de vous</translation>
    </message>
    <message>
        <source>Move the handle %1 cm to your right and hold it there.</source>
        <translation>Déplacez la poignée de %1 cm vers votre droite et maintenez-la à cet endroit.</translation>
    </message>
    <message>
        <source>Hold the handle still in the middle of its workspace.</source>
        <translation>Maintenez la poignée immobile au milieu de son espace de travail.</translation>
    </message>
    <message>
        <source>Move the handle %1 cm away from you and hold it there.</source>
        <translation>Éloignez la poignée de vous de %1 cm et maintenez-la à cet endroit.</translation>
    </message>
    <message>
        <source>Move the handle %1 cm up and hold it there.</source>
        <translation>Déplacez la poignée de %1 cm vers le haut et maintenez-la à cet endroit.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device follows.</source>
        <translation>Mouvement %1&#x202f;: l’appareil suit.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion %2. This axis is reversed.</source>
        <translation>Mouvement %1&#x202f;: l’appareil indique un mouvement %2. Cet axe est inversé.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion %2. This axis is another one.</source>
        <translation>Mouvement %1&#x202f;: l’appareil indique un mouvement %2. Cet axe est permuté.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion between two axes, mostly %2.</source>
        <translation>Mouvement %1&#x202f;: l’appareil indique un mouvement entre deux axes, surtout %2.</translation>
    </message>
    <message>
        <source>Asked to move %1: no such motion within %2 s.</source>
        <translation>Mouvement %1&#x202f;: aucun mouvement de ce genre en %2 s.</translation>
    </message>
    <message>
        <source>Check that %1 is calibrated and that its tooltip in the tool bar reports no problem, then repeat the check.</source>
        <translation>Vérifiez que %1 est étalonné et que son infobulle dans la barre d’outils ne signale aucun problème, puis répétez la vérification.</translation>
    </message>
    <message>
        <source>%1 mirrors the motion: an encoder counts backwards. Do not touch with forces. Calibrate the device in its calibration pose; for WoodenHaptics, correct &quot;variant&quot; in woodenhaptics.json. Then repeat the check.</source>
        <translation>%1 inverse le mouvement comme un miroir&#x202f;: un codeur compte à rebours. Ne palpez pas avec des forces. Étalonnez l’appareil dans sa position d’étalonnage&#x202f;; pour WoodenHaptics, corrigez &quot;variant&quot; dans woodenhaptics.json. Répétez ensuite la vérification.</translation>
    </message>
    <message>
        <source>%1 is turned: turn its base so that it faces you, then repeat the check. To align the device with the patient instead of the view, use &quot;Aligned with&quot; in the panel Device.</source>
        <translation>%1 est tourné&#x202f;: orientez son socle vers vous, puis répétez la vérification. Pour aligner l’appareil sur le patient plutôt que sur la vue, utilisez l’alignement du panneau Appareil.</translation>
    </message>
    <message>
        <source>Put the handle into the middle of its workspace and let go of it. If it does not stay there by itself, hold it still.</source>
        <translation>Placez la poignée au milieu de son espace de travail et lâchez-la. Si elle n’y reste pas d’elle-même, maintenez-la immobile.</translation>
    </message>
    <message>
        <source>Do not touch the handle. Small forces move it.</source>
        <translation>Ne touchez pas la poignée. De petites forces la déplacent.</translation>
    </message>
    <message>
        <source>Now hold the handle like a pen, in the middle of its workspace, and keep it there.</source>
        <translation>Tenez maintenant la poignée comme un stylo, au milieu de son espace de travail, et gardez-la à cet endroit.</translation>
    </message>
    <message>
        <source>Keep your hand in its place. A wall comes towards you, gives way a little and stops, and is a little stiffer each time.</source>
        <translation>Gardez la main en place. Une paroi vient vers vous, cède un peu et s’arrête&#x202f;; elle est chaque fois un peu plus raide.</translation>
    </message>
    <message>
        <source>The test was stopped.</source>
        <translation>Le test a été interrompu.</translation>
    </message>
    <message>
        <source>The device gave no position inside of its workspace. Put the handle into the middle of the workspace, calibrate the device if it needs to be, and start the test again.</source>
        <translation>L’appareil n’a donné aucune position dans son espace de travail. Placez la poignée au milieu de l’espace de travail, étalonnez l’appareil si nécessaire et relancez le test.</translation>
    </message>
    <message>
        <source>The device has no motors, so that only the position at rest was tested.</source>
        <translation>L’appareil n’a pas de moteurs&#x202f;; seule la position au repos a été testée.</translation>
    </message>
    <message>
        <source>The position did not clearly follow the force. Check that the motors have power and that forces are switched on, and start the test again without a hand at the handle until the test asks for one.</source>
        <translation>La position n’a pas suivi nettement la force. Vérifiez que les moteurs sont alimentés et que les forces sont activées, puis relancez le test sans tenir la poignée tant que le test ne le demande pas.</translation>
    </message>
    <message>
        <source>The handle moved against the force: an axis or a motor is reversed. Do not touch with this device until the settings of its driver are corrected.</source>
        <translation>La poignée s’est déplacée contre la force&#x202f;: un axe ou un moteur est inversé. Ne palpez pas avec cet appareil avant d’avoir corrigé les réglages de son pilote.</translation>
    </message>
    <message>
        <source>Nobody held the handle, so that no wall was tested. Start the test again and hold the handle when asked.</source>
        <translation>Personne ne tenait la poignée, aucune paroi n’a donc été testée. Relancez le test et tenez la poignée lorsque cela est demandé.</translation>
    </message>
    <message>
        <source>The hand gave way or let go of the handle. Start the test again and keep the hand in its place.</source>
        <translation>La main a cédé ou a lâché la poignée. Relancez le test et gardez la main en place.</translation>
    </message>
    <message>
        <source>The test took too long and was stopped.</source>
        <translation>Le test a duré trop longtemps et a été interrompu.</translation>
    </message>
    <message>
        <source>noise and resolution were not measured</source>
        <translation>le bruit et la résolution n’ont pas été mesurés</translation>
    </message>
    <message>
        <source>friction was not measured: the handle did not rest</source>
        <translation>le frottement n’a pas été mesuré&#x202f;: la poignée n’était pas au repos</translation>
    </message>
    <message>
        <source>friction was not measured: %1 N did not move the handle</source>
        <translation>le frottement n’a pas été mesuré&#x202f;: %1 N n’ont pas déplacé la poignée</translation>
    </message>
    <message>
        <source>the round trip was not measured</source>
        <translation>le temps d’aller-retour n’a pas été mesuré</translation>
    </message>
    <message>
        <source>the held stiffness was not measured</source>
        <translation>la raideur tenue n’a pas été mesurée</translation>
    </message>
    <message>
        <source>the test is already running</source>
        <translation>le test est déjà en cours</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>less than %1 N/mm</source>
        <translation>moins de %1 N/mm</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Temps aller-retour</translation>
    </message>
    <message>
        <source>%1 ms median, %2 ms 99th percentile</source>
        <translation>médiane %1 ms, 99ᵉ centile %2 ms</translation>
    </message>
    <message>
        <source>%1 pulses; from sending a force to seeing it act</source>
        <translation>%1 impulsions&#x202f;; de l’envoi d’une force à son effet visible</translation>
    </message>
    <message>
        <source>Mass at the handle</source>
        <translation>Masse à la poignée</translation>
    </message>
    <message>
        <source>%1 g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>with the hand, if it was held during the pulses</source>
        <translation>avec la main, si la poignée était tenue pendant les impulsions</translation>
    </message>
    <message>
        <source>Answer of the driver</source>
        <translation>Réponse du pilote</translation>
    </message>
    <message>
        <source>from receiving a position to sending its force; ticks of the loop: %1</source>
        <translation>de la réception d’une position à l’envoi de sa force&#x202f;; cycles de la boucle&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 new positions per second</source>
        <translation>%1 nouvelles positions par seconde</translation>
    </message>
    <message>
        <source>loop %1 Hz of %2 Hz, late ticks: %3</source>
        <translation>boucle %1 Hz sur %2 Hz, cycles en retard&#x202f;: %3</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>the driver states %1 mm</source>
        <translation>le pilote indique %1 mm</translation>
    </message>
    <message>
        <source>Noise at rest</source>
        <translation>Bruit au repos</translation>
    </message>
    <message>
        <source>%1 mm root mean square, %2 mm peak to peak</source>
        <translation>%1 mm en moyenne quadratique, %2 mm de crête à crête</translation>
    </message>
    <message>
        <source>deviation from a line over 50 ms</source>
        <translation>écart à une droite sur 50 ms</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>%1 ± %2 N</source>
        <translation>%1 ± %2 N</translation>
    </message>
    <message>
        <source>force at which the handle breaks away, in both directions</source>
        <translation>force à laquelle la poignée se met en mouvement, dans les deux sens</translation>
    </message>
    <message>
        <source>Held stiffness, without the controller</source>
        <translation>Raideur tenue, sans le régulateur</translation>
    </message>
    <message>
        <source>Held stiffness, with the controller</source>
        <translation>Raideur tenue, avec le régulateur</translation>
    </message>
    <message>
        <source>Palpate renders at most %1 N/mm on this device</source>
        <translation>Palpate restitue au plus %1 N/mm sur cet appareil</translation>
    </message>
    <message>
        <source>Stiffness stated for the device</source>
        <translation>Raideur annoncée pour l’appareil</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1&#x202f;: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>1 hole of %1 mm closed, %2 of new surface</source>
        <translation>1 trou de %1 mm fermé, %2 de surface nouvelle</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 mm closed, %3 of new surface</source>
        <translation>%1 trous jusqu’à %2 mm fermés, %3 de surface nouvelle</translation>
    </message>
    <message>
        <source>area %1, extent %2 × %3 × %4 mm</source>
        <translation>aire %1, étendue %2 × %3 × %4 mm</translation>
    </message>
    <message>
        <source>volume %1 (a ball of %2 mm), %3</source>
        <translation>volume %1 (une boule de %2 mm), %3</translation>
    </message>
    <message>
        <source>Findings marked outside of this recording: %1, in a table of their own.</source>
        <translation>Points marqués hors de cet enregistrement&#x202f;: %1, dans un tableau à part.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Findings marked outside of this recording: before it, after its end or in another one. This recording says nothing about their examination.</source>
        <translation>Points marqués hors de cet enregistrement&#x202f;: avant, après sa fin ou dans un autre. Cet enregistrement ne dit rien de leur examen.</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Marqué</translation>
    </message>
    <message>
        <source>a count from 1 to %1 for each of %2 axes</source>
        <translation>un nombre de 1 à %1 pour chacun des %2 axes</translation>
    </message>
    <message>
        <source>0, or the bytes before uncompressed voxels, or -1 if the voxels end with their file</source>
        <translation>0, le nombre d’octets avant des voxels non compressés, ou -1 si les voxels sont à la fin du fichier</translation>
    </message>
    <message>
        <source>more than %1 numbers per voxel</source>
        <translation>plus de %1 nombres par voxel</translation>
    </message>
    <message>
        <source>0: voxels from the first line on</source>
        <translation>0&#x202f;: voxels dès la première ligne</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels</source>
        <translation>%1 × %2 × %3 voxels</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels with %4 numbers each</source>
        <translation>%1 × %2 × %3 voxels de %4 nombres chacun</translation>
    </message>
    <message>
        <source>three axes that are not in one plane, with a voxel size above 0</source>
        <translation>trois axes qui ne sont pas dans un même plan et une taille de voxel supérieure à 0</translation>
    </message>
    <message>
        <source>%1; copy the readable parts with `palpate session recover`</source>
        <translation>%1&#x202f;; copiez les parties lisibles avec `palpate session recover`</translation>
    </message>
    <message>
        <source>%1: not made by Palpate, or damaged</source>
        <translation>%1&#x202f;: pas créé par Palpate, ou endommagé</translation>
    </message>
    <message>
        <source>a file without them</source>
        <translation>un fichier sans ceux-ci</translation>
    </message>
    <message>
        <source>a line with ElementDataFile, within %1 bytes</source>
        <translation>une ligne avec ElementDataFile, dans les %1 premiers octets</translation>
    </message>
    <message>
        <source>an empty line after it, within %1 bytes</source>
        <translation>une ligne vide après, dans les %1 premiers octets</translation>
    </message>
    <message>
        <source>a number for each axis in space</source>
        <translation>un nombre pour chaque axe dans l’espace</translation>
    </message>
    <message>
        <source>a unit for each of three axes: &quot;mm&quot;, &quot;cm&quot;, &quot;m&quot; or &quot;um&quot;</source>
        <translation>une unité pour chacun des trois axes&#x202f;: &quot;mm&quot;, &quot;cm&quot;, &quot;m&quot; ou &quot;um&quot;</translation>
    </message>
    <message>
        <source>an origin that is not finite</source>
        <translation>une origine qui n’est pas finie</translation>
    </message>
    <message>
        <source>%1 with %2 bytes of voxels</source>
        <translation>%1 avec %2 octets de voxels</translation>
    </message>
    <message>
        <source>%1 in each of %2 files</source>
        <translation>%1 dans chacun des %2 fichiers</translation>
    </message>
    <message>
        <source>%1 finite numbers</source>
        <translation>%1 nombres finis</translation>
    </message>
    <message>
        <source>the first and last number of a voxel along each axis, at most %1 apart</source>
        <translation>le premier et le dernier numéro d’un voxel sur chaque axe, distants d’au plus %1</translation>
    </message>
    <message>
        <source>%1 arrays, none of them marked as the scalars</source>
        <translation>%1 tableaux, aucun n’est marqué comme scalaires</translation>
    </message>
    <message>
        <source>numbers of type %1</source>
        <translation>des nombres de type %1</translation>
    </message>
    <message>
        <source>a part of the whole, %1</source>
        <translation>une partie du tout, %1</translation>
    </message>
    <message>
        <source>pieces that cover the whole extent</source>
        <translation>des morceaux qui couvrent toute l’étendue</translation>
    </message>
    <message>
        <source>a surface. As a map of stiffness, a volume is named in a scene (maps.md)</source>
        <translation>une surface. Comme carte de raideur, un volume est nommé dans une scène (maps.md)</translation>
    </message>
    <message>
        <source>the files that it names, or a name that ends in .vtm</source>
        <translation>les fichiers qu’il nomme, ou un nom qui finit par .vtm</translation>
    </message>
    <message>
        <source>a volume of VTK</source>
        <translation>un volume de VTK</translation>
    </message>
    <message>
        <source>a VTK file that names the parts of a surface (.pvtp)</source>
        <translation>un fichier VTK qui nomme les parties d’une surface (.pvtp)</translation>
    </message>
    <message>
        <source>the .vtp files that it names, in a folder</source>
        <translation>les fichiers .vtp qu’il nomme, dans un dossier</translation>
    </message>
    <message>
        <source>a VTK file that names the parts of a grid (.pvtu)</source>
        <translation>un fichier VTK qui nomme les parties d’une grille (.pvtu)</translation>
    </message>
    <message>
        <source>the .vtu files that it names, in a folder</source>
        <translation>les fichiers .vtu qu’il nomme, dans un dossier</translation>
    </message>
    <message>
        <source>a VTK file that names other files (.vtpd)</source>
        <translation>un fichier VTK qui nomme d’autres fichiers (.vtpd)</translation>
    </message>
    <message>
        <source>a VTK file that names other files (.vtpc)</source>
        <translation>un fichier VTK qui nomme d’autres fichiers (.vtpc)</translation>
    </message>
    <message>
        <source>a volume of FreeSurfer (.mgz, .mgh)</source>
        <translation>un volume de FreeSurfer (.mgz, .mgh)</translation>
    </message>
    <message>
        <source>a label map as NIfTI (FreeSurfer: mri_convert to a name that ends in .nii.gz)</source>
        <translation>une carte d’étiquettes en NIfTI (FreeSurfer&#x202f;: mri_convert vers un nom qui finit par .nii.gz)</translation>
    </message>
    <message>
        <source>the count of triangles in the header, %1, is wrong: the size of the file says %2</source>
        <translation>le nombre de triangles de l’en-tête, %1, est faux&#x202f;: d’après la taille du fichier, il y en a %2</translation>
    </message>
    <message>
        <source>a text without the facets of an STL</source>
        <translation>un texte sans les facettes d’un STL</translation>
    </message>
    <message>
        <source>the text is UTF-16, but the appended data are raw bytes</source>
        <translation>le texte est en UTF-16, mais les données ajoutées sont des octets bruts</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>is a folder of DICOM images, which Palpate does not read</source>
        <translation>est un dossier d’images DICOM, que Palpate ne lit pas</translation>
    </message>
    <message>
        <source>a segmentation: load the DICOM images in 3D Slicer, segment the organs and save the segmentation as .seg.nrrd, or let TotalSegmentator make one; then open that file</source>
        <translation>une segmentation&#x202f;: chargez les images DICOM dans 3D Slicer, segmentez les organes et enregistrez la segmentation en .seg.nrrd, ou laissez TotalSegmentator en faire une&#x202f;; ouvrez ensuite ce fichier</translation>
    </message>
    <message>
        <source>is a DICOM image, which Palpate does not read</source>
        <translation>est une image DICOM, que Palpate ne lit pas</translation>
    </message>
    <message>
        <source>a label map: whole numbers from 0, one for each structure. A CT or MR image is segmented first (3D Slicer, TotalSegmentator), or shown in the sections of an open scene (View › Section plane › Show an image…). As a map of stiffness, a volume is named in a scene (maps.md)</source>
        <translation>une carte d’étiquettes&#x202f;: des nombres entiers à partir de 0, un par structure. Une image CT ou IRM est d’abord segmentée (3D Slicer, TotalSegmentator), ou affichée dans les coupes d’une scène ouverte (Affichage › Plan de coupe › Afficher une image…). Comme carte de raideur, un volume est nommé dans une scène (maps.md)</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>événements&#x202f;: %1</translation>
    </message>
    <message>
        <source>ticks up to %1: %2</source>
        <translation>pas jusqu’à %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>kept, but not verified, because the checksums are lost: %1</source>
        <translation>conservé, mais non vérifié, car les sommes de contrôle sont perdues&#x202f;: %1</translation>
    </message>
    <message>
        <source>the end may be missing: the recording was closed, but the file is damaged or cut off; nothing is known after tick %1</source>
        <translation>la fin manque peut-être&#x202f;: l’enregistrement a été fermé, mais le fichier est endommagé ou tronqué&#x202f;; rien n’est connu après le pas %1</translation>
    </message>
    <message>
        <source>&lt; %1</source>
        <translation>&lt; %1</translation>
    </message>
    <message>
        <source>Touched structures: %1.</source>
        <translation>Structures touchées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Distances measured with the tape: %1 (%2).</source>
        <translation>Distances mesurées au mètre&#x202f;: %1 (%2).</translation>
    </message>
    <message>
        <source>Least distances, nearest first</source>
        <translation>Plus petites distances, les plus proches d’abord</translation>
    </message>
    <message>
        <source>Not listed: %1 more structures that cross or touch others.</source>
        <translation>Non listées&#x202f;: %1 autres structures qui en croisent ou en touchent d’autres.</translation>
    </message>
    <message>
        <source>%1 crosses or touches (0 mm): %2.</source>
        <translation>%1 croise ou touche (0 mm)&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Of %1 pairs of structures, %2 are left out. Listed are the nearest pairs with a structure that was touched, holds or borders a finding or the end of a tape, or is a lump. All pairs: `palpate info --distances --json SCENE`, or View › Distances and sizes in the window.</source>
        <translation>Sur %1 paires de structures, %2 sont omises. Sont listées les paires les plus proches avec une structure qui a été touchée, qui porte ou borde un point repéré ou l’extrémité d’un mètre, ou qui est un nodule. Toutes les paires&#x202f;: `palpate info --distances --json SCENE`, ou Affichage › Distances et tailles dans la fenêtre.</translation>
    </message>
    <message>
        <source>Margins left out, with less of the lump&apos;s surface nearby: %1. All margins: `palpate info --distances --json SCENE`.</source>
        <translation>Marges omises, dont une moindre part de la surface du nodule est proche&#x202f;: %1. Toutes les marges&#x202f;: `palpate info --distances --json SCENE`.</translation>
    </message>
    <message>
        <source>No volume, because the surface is open, for %1 structures: %2.</source>
        <translation>Pas de volume, car la surface est ouverte, pour %1 structures&#x202f;: %2.</translation>
    </message>
    <message>
        <source>No volume, because the surface is inside out, for %1 structures: %2.</source>
        <translation>Pas de volume, car la surface est retournée, pour %1 structures&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Volume of the closed parts alone, for %1 structures: %2.</source>
        <translation>Volume des seules parties fermées, pour %1 structures&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Measured distances</source>
        <translation>Distances mesurées</translation>
    </message>
    <message>
        <source>Straight distances between two places, measured by the examiner with the tape</source>
        <translation>Distances droites entre deux points, mesurées par l’examinateur au mètre</translation>
    </message>
    <message>
        <source>Structures left out of this table: %1. All sizes: `palpate info --distances --json SCENE`.</source>
        <translation>Structures omises de ce tableau&#x202f;: %1. Toutes les tailles&#x202f;: `palpate info --distances --json SCENE`.</translation>
    </message>
    <message>
        <source>Surfaces without a checksum, because they were not palpable: %1.</source>
        <translation>Surfaces sans somme de contrôle, car elles n’étaient pas palpables&#x202f;: %1.</translation>
    </message>
    <message>
        <source>pieces that cover the whole extent once</source>
        <translation>des morceaux qui couvrent toute l’étendue une fois</translation>
    </message>
    <message>
        <source>a file in more than %1 levels or behind %2 files</source>
        <translation>un fichier sur plus de %1 niveaux ou après %2 fichiers</translation>
    </message>
    <message>
        <source>fewer files that name others</source>
        <translation>moins de fichiers qui en nomment d’autres</translation>
    </message>
    <message>
        <source>it names only itself</source>
        <translation>il ne nomme que lui-même</translation>
    </message>
    <message>
        <source>at least one mesh file</source>
        <translation>au moins un fichier de maillage</translation>
    </message>
</context>
<context>
    <name>palpate::app::AxisCheckDialog</name>
    <message>
        <source>Check of the axes</source>
        <translation>Vérification des axes</translation>
    </message>
    <message>
        <source>All axes follow the hand.</source>
        <translation>Tous les axes suivent la main.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ComparisonDialog</name>
    <message>
        <source>Comparison of %1 (A) and %2 (B)</source>
        <translation>Comparaison de %1 (A) et %2 (B)</translation>
    </message>
    <message>
        <source>Comparison of two recordings</source>
        <translation>Comparaison de deux enregistrements</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy all tables for a spreadsheet</source>
        <translation>Copier tous les tableaux pour un tableur</translation>
    </message>
    <message>
        <source>By hand: a hand can tell two forces apart from about 7 % on (measured from 2.5 to 10 N).</source>
        <translation>À la main&#x202f;: une main distingue deux forces à partir d’environ 7 % (mesuré de 2,5 à 10 N).</translation>
    </message>
</context>
<context>
    <name>palpate::app::ComparisonPart</name>
    <message>
        <source>Compare with…</source>
        <translation>Comparer avec…</translation>
    </message>
    <message>
        <source>Compare the recording with a second one of the same structures</source>
        <translation>Comparer l’enregistrement avec un second des mêmes structures</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminer la comparaison</translation>
    </message>
    <message>
        <source>Second recording</source>
        <translation>Second enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.palpate)</source>
        <translation>Enregistrements (*.palpate)</translation>
    </message>
</context>
<context>
    <name>palpate::app::CoordinatesPart</name>
    <message>
        <source>Stop the recording first: it uses the current coordinates.</source>
        <translation>Arrêtez d’abord l’enregistrement&#x202f;: il utilise les coordonnées actuelles.</translation>
    </message>
</context>
<context>
    <name>palpate::app::DevicePart</name>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>The pointer sets the place, the SpaceMouse the force: push its cap down. P palpate, wheel for the force limit</source>
        <translation>Le pointeur choisit l’endroit, la SpaceMouse la force&#x202f;: poussez son palet vers le bas. P palpe, la molette règle la force maximale</translation>
    </message>
    <message>
        <source>Press by effort</source>
        <translation>Appuyer par effort</translation>
    </message>
    <message>
        <source>Press with a set force: it rises while the button is held, or follows the pressure of a pen, and stiff tissue yields less. Off: the wheel sets the depth</source>
        <translation>Appuyer avec une force réglée&#x202f;: elle croît tant que le bouton est tenu, ou suit la pression d’un stylet, et un tissu raide cède moins. Désactivé&#x202f;: la molette règle la profondeur</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Lever la main</translation>
    </message>
    <message>
        <source>Move the device without moving the hand in the scene, like lifting a mouse; press again to continue</source>
        <translation>Déplacer l’appareil sans déplacer la main dans la scène, comme on lève une souris&#x202f;; encore une fois pour continuer</translation>
    </message>
    <message>
        <source>Fit the workspace to the scene</source>
        <translation>Ajuster l’espace de travail à la scène</translation>
    </message>
    <message>
        <source>The workspace of the device covers everything shown</source>
        <translation>L’espace de travail de l’appareil couvre tout ce qui est affiché</translation>
    </message>
    <message>
        <source>Fit the workspace to the organ</source>
        <translation>Ajuster l’espace de travail à l’organe</translation>
    </message>
    <message>
        <source>The workspace of the device covers the organ that is touched or under the pointer</source>
        <translation>L’espace de travail de l’appareil couvre l’organe touché ou sous le pointeur</translation>
    </message>
    <message>
        <source>Fit the workspace to the lump</source>
        <translation>Ajuster l’espace de travail au nodule</translation>
    </message>
    <message>
        <source>The workspace of the device covers 10 mm around the place that is touched, under the pointer or marked</source>
        <translation>L’espace de travail de l’appareil couvre 10 mm autour de l’endroit touché, sous le pointeur ou repéré</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>A&amp;ppareil</translation>
    </message>
    <message>
        <source>Touch with the device; O or L fits the workspace to the organ or lump, C lifts the hand</source>
        <translation>Toucher avec l’appareil&#x202f;; O ou L ajuste l’espace de travail à l’organe ou au nodule, C lève la main</translation>
    </message>
    <message>
        <source>Restore the force</source>
        <translation>Rétablir la force</translation>
    </message>
    <message>
        <source>My threshold…</source>
        <translation>Mon seuil…</translation>
    </message>
    <message>
        <source>Measure the smallest increase of stiffness that your hand detects</source>
        <translation>Mesurer la plus petite augmentation de rigidité que votre main détecte</translation>
    </message>
    <message>
        <source>Stop the recording before you measure your threshold.</source>
        <translation>Arrêtez l’enregistrement avant de mesurer votre seuil.</translation>
    </message>
    <message>
        <source>Test…</source>
        <translation>Tester…</translation>
    </message>
    <message>
        <source>Measure round trip, noise, friction and the stiffness that the device holds</source>
        <translation>Mesurer le temps d’aller-retour, le bruit, le frottement et la raideur que l’appareil tient</translation>
    </message>
    <message>
        <source>Check the axes…</source>
        <translation>Vérifier les axes…</translation>
    </message>
    <message>
        <source>Check whether the device moves as the hand does</source>
        <translation>Vérifier si l’appareil se déplace comme la main</translation>
    </message>
    <message>
        <source>Check once whether %1 moves as your hand does.</source>
        <translation>Vérifiez une fois que %1 bouge comme votre main.</translation>
    </message>
    <message>
        <source>Hold to press harder, wheel for the force limit; then Mark; right drag turns the view</source>
        <translation>Maintenir appuie plus fort, la molette règle la force maximale&#x202f;; puis Marquer&#x202f;; glisser avec le bouton droit tourne la vue</translation>
    </message>
    <message>
        <source>Drag to press, wheel for depth; then Mark; right drag turns the view</source>
        <translation>Glisser pour appuyer, molette pour la profondeur&#x202f;; puis Marquer&#x202f;; glisser avec le bouton droit tourne la vue</translation>
    </message>
    <message>
        <source>Palpate (P): hold to press harder, wheel for the force limit</source>
        <translation>Palper (P)&#x202f;: maintenir appuie plus fort, la molette règle la force maximale</translation>
    </message>
    <message>
        <source>Palpate (P): drag to press, wheel for depth</source>
        <translation>Palper (P)&#x202f;: glisser pour appuyer, molette pour la profondeur</translation>
    </message>
</context>
<context>
    <name>palpate::app::DistancesPart</name>
    <message>
        <source>Distances and sizes</source>
        <translation>Distances et tailles</translation>
    </message>
    <message>
        <source>Measure the distances and margins of lumps to other structures, and list the tapes</source>
        <translation>Mesurer les distances et les marges des nodules aux autres structures, et lister les mètres</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Mètre</translation>
    </message>
    <message>
        <source>Measure between two places: click on both, or touch both and press T each time; snaps to findings</source>
        <translation>Mesurer entre deux points&#x202f;: cliquer sur les deux, ou toucher les deux en appuyant chaque fois sur T&#x202f;; s’aligne sur les observations</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
</context>
<context>
    <name>palpate::app::Docks</name>
    <message>
        <source>Next panel</source>
        <translation>Panneau suivant</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the next panel, after the last to the view</source>
        <translation>Placer le focus clavier sur le panneau suivant, puis sur la vue</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Panneau précédent</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the previous panel</source>
        <translation>Placer le focus clavier sur le panneau précédent</translation>
    </message>
    <message>
        <source>Hide or show all panels</source>
        <translation>Masquer ou afficher les panneaux</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
</context>
<context>
    <name>palpate::app::DocumentPart</name>
    <message>
        <source>Save scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
    <message>
        <source>Save the scene with its tissue</source>
        <translation>Enregistrer la scène avec ses tissus</translation>
    </message>
    <message>
        <source>Save scene as…</source>
        <translation>Enregistrer la scène sous…</translation>
    </message>
    <message>
        <source>Save the scene with its tissue to another file</source>
        <translation>Enregistrer la scène avec ses tissus dans un autre fichier</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Annuler le dernier changement</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Rétablir le dernier changement annulé</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler&#x202f;: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rétablir&#x202f;: %1</translation>
    </message>
    <message>
        <source>The scene was changed elsewhere</source>
        <translation>La scène a été modifiée ailleurs</translation>
    </message>
    <message>
        <source>Another window or program has saved %1 since it was opened here. Saving would replace that version.</source>
        <translation>Une autre fenêtre ou un autre programme a enregistré %1 depuis son ouverture ici. Enregistrer remplacerait cette version.</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Enregistrer quand même</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Palpate scene (*.palpate.json)</source>
        <translation>Scène Palpate (*.palpate.json)</translation>
    </message>
    <message>
        <source>Scene saved to %1</source>
        <translation>Scène enregistrée dans %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>Save the changes to this scene?</source>
        <translation>Enregistrer les changements de cette scène&#x202f;?</translation>
    </message>
    <message>
        <source>Palpate[*]</source>
        <translation>Palpate[*]</translation>
    </message>
    <message>
        <source>Unsaved scene</source>
        <translation>Scène non enregistrée</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>%1[*] – Palpate</source>
        <translation>%1[*] – Palpate</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly. Unsaved changes of a scene can be restored.</source>
        <translation>Palpate s’est arrêté brutalement. Des changements non enregistrés d’une scène peuvent être récupérés.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>These changes were already restored in another window.</source>
        <translation>Ces changements ont déjà été récupérés dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>Unsaved copy of %1</source>
        <translation>Copie non enregistrée de %1</translation>
    </message>
</context>
<context>
    <name>palpate::app::EngineeringPart</name>
    <message>
        <source>State of the servo loop</source>
        <translation>État de la boucle d’asservissement</translation>
    </message>
    <message>
        <source>Engineering</source>
        <translation>Technique</translation>
    </message>
    <message>
        <source>Show or hide measurements of solver, servo loop and device</source>
        <translation>Afficher ou masquer les mesures du solveur, de la boucle et de l’appareil</translation>
    </message>
    <message>
        <source>Forces may stutter: %1: %2. %3</source>
        <translation>La force peut saccader&#x202f;: %1&#x202f;: %2. %3</translation>
    </message>
</context>
<context>
    <name>palpate::app::ExerciseDialog</name>
    <message>
        <source>Results of the exercise</source>
        <translation>Résultats de l’exercice</translation>
    </message>
    <message>
        <source>Scoring the recording…</source>
        <translation>Évaluation de l’enregistrement…</translation>
    </message>
    <message>
        <source>Result of saving</source>
        <translation>Résultat de l’enregistrement du fichier</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>Enregistrer la page…</translation>
    </message>
    <message>
        <source>Save this page with a picture as PDF or web page</source>
        <translation>Enregistrer cette page avec une image en PDF ou page web</translation>
    </message>
    <message>
        <source>Save numbers (JSON)…</source>
        <translation>Enregistrer les nombres (JSON)…</translation>
    </message>
    <message>
        <source>Save the numbers in machine-readable form, as palpate session exercise writes them</source>
        <translation>Enregistrer les nombres sous forme lisible par machine, comme les écrit palpate session exercise</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Refaire</translation>
    </message>
    <message>
        <source>Hide the targets again for another search</source>
        <translation>Cacher de nouveau les cibles pour une autre recherche</translation>
    </message>
    <message>
        <source>Page of the exercise</source>
        <translation>Page de l’exercice</translation>
    </message>
    <message>
        <source>PDF for printing (*.pdf);;Web page, for screen readers too (*.html)</source>
        <translation>PDF à imprimer (*.pdf);;Page web, aussi pour lecteurs d’écran (*.html)</translation>
    </message>
    <message>
        <source>Numbers of the exercise</source>
        <translation>Nombres de l’exercice</translation>
    </message>
    <message>
        <source>Numbers (*.json)</source>
        <translation>Nombres (*.json)</translation>
    </message>
    <message>
        <source>Nothing was written: %1 must end in .pdf, .html or .json.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 doit se terminer par .pdf, .html ou .json.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ExercisePart</name>
    <message>
        <source>Search for the hidden targets: records the hand until the end</source>
        <translation>Chercher les cibles cachées&#x202f;: enregistre la main jusqu’à la fin</translation>
    </message>
    <message>
        <source>Start the exercise</source>
        <translation>Commencer l’exercice</translation>
    </message>
    <message>
        <source>Show the targets…</source>
        <translation>Montrer les cibles…</translation>
    </message>
    <message>
        <source>Give up the exercise without a search</source>
        <translation>Abandonner l’exercice sans recherche</translation>
    </message>
    <message>
        <source>Do the exercise again</source>
        <translation>Refaire l’exercice</translation>
    </message>
    <message>
        <source>Hide the targets again for another search</source>
        <translation>Cacher de nouveau les cibles pour une autre recherche</translation>
    </message>
    <message>
        <source>Results of the exercise…</source>
        <translation>Résultats de l’exercice…</translation>
    </message>
    <message>
        <source>Found and missed targets, time, coverage and force of the last search</source>
        <translation>Cibles trouvées et manquées, temps, couverture et force de la dernière recherche</translation>
    </message>
    <message>
        <source>End the exercise</source>
        <translation>Terminer l’exercice</translation>
    </message>
    <message>
        <source>Off until the exercise ends, because it could show the hidden targets</source>
        <translation>Désactivé jusqu’à la fin de l’exercice, car cela pourrait montrer les cibles cachées</translation>
    </message>
    <message>
        <source>The recording starts with the exercise (Session menu)</source>
        <translation>L’enregistrement commence avec l’exercice (menu Session)</translation>
    </message>
    <message>
        <source>This scene is an exercise: find the hidden targets by touch. Start it in the view or in the Session menu.</source>
        <translation>Cette scène est un exercice&#x202f;: trouvez les cibles cachées par le toucher. Commencez-le dans la vue ou dans le menu Session.</translation>
    </message>
    <message>
        <source>Stop the recording before you start the exercise.</source>
        <translation>Arrêtez l’enregistrement avant de commencer l’exercice.</translation>
    </message>
    <message>
        <source>Show the targets without a search? Whoever has seen them cannot search for them any more.</source>
        <translation>Montrer les cibles sans recherche&#x202f;? Qui les a vues ne peut plus les chercher.</translation>
    </message>
    <message>
        <source>Show the targets</source>
        <translation>Montrer les cibles</translation>
    </message>
    <message>
        <source>Keep them hidden</source>
        <translation>Les laisser cachées</translation>
    </message>
    <message>
        <source>Stop the recording before you do the exercise again.</source>
        <translation>Arrêtez l’enregistrement avant de refaire l’exercice.</translation>
    </message>
    <message>
        <source>Time is up.</source>
        <translation>Le temps est écoulé.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n cible cachée</numerusform>
            <numerusform>%n cibles cachées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marked</source>
        <translation>
            <numerusform>%n marqué</numerusform>
            <numerusform>%n marqués</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>reste %1</translation>
    </message>
    <message>
        <source>%1 N: above the ceiling of %2 N</source>
        <translation>%1 N&#x202f;: au-dessus du plafond de %2 N</translation>
    </message>
    <message>
        <source>%1 N, ceiling %2 N</source>
        <translation>%1 N, plafond %2 N</translation>
    </message>
    <message numerus="yes">
        <source>Exercise: %n hidden target(s)</source>
        <translation>
            <numerusform>Exercice&#x202f;: %n cible cachée</numerusform>
            <numerusform>Exercice&#x202f;: %n cibles cachées</numerusform>
        </translation>
    </message>
    <message>
        <source>Force ceiling %1 N</source>
        <translation>Plafond de force %1 N</translation>
    </message>
    <message>
        <source>Find them by touch. The search is recorded. Sections, peek, maps, distances, results and reports are off until the end.</source>
        <translation>Trouvez-les par le toucher. La recherche est enregistrée. Coupes, aperçu, cartes, distances, résultats et rapports sont désactivés jusqu’à la fin.</translation>
    </message>
    <message>
        <source>Exercise: the targets are shown</source>
        <translation>Exercice&#x202f;: les cibles sont montrées</translation>
    </message>
    <message>
        <source>%1: found after %2 s</source>
        <translation>%1&#x202f;: trouvée après %2 s</translation>
    </message>
    <message>
        <source>%1: missed</source>
        <translation>%1&#x202f;: manquée</translation>
    </message>
    <message>
        <source>The exercise runs. Mark each place that you find (Mark in the tool bar or M).</source>
        <translation>L’exercice est en cours. Marquez chaque endroit que vous trouvez (Marquer dans la barre d’outils ou M).</translation>
    </message>
    <message>
        <source>At each place that you find, click Mark or press M.</source>
        <translation>À chaque endroit que vous trouvez, cliquez sur Marquer ou appuyez sur M.</translation>
    </message>
</context>
<context>
    <name>palpate::app::FindingsPart</name>
    <message>
        <source>Import findings…</source>
        <translation>Importer des points…</translation>
    </message>
    <message>
        <source>Import the points of a 3D Slicer markups file (.mrk.json) as findings</source>
        <translation>Importer les points d’un fichier 3D Slicer (.mrk.json) comme points repérés</translation>
    </message>
    <message>
        <source>Export findings…</source>
        <translation>Exporter les points…</translation>
    </message>
    <message>
        <source>Export findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)</source>
        <translation>Exporter points repérés et notes en tableau (CSV) ou en annotations 3D Slicer (.mrk.json)</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Points repérés</translation>
    </message>
    <message>
        <source>Show the places marked as findings</source>
        <translation>Afficher les endroits marqués comme points repérés</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Marquer un point</translation>
    </message>
    <message>
        <source>Mark a finding and write…</source>
        <translation>Marquer un point et écrire…</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Note…</translation>
    </message>
    <message>
        <source>Write a note without a place</source>
        <translation>Écrire une note sans endroit</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Point suivant</translation>
    </message>
    <message>
        <source>Go to the next finding and restore the view in which it was marked</source>
        <translation>Aller au point repéré suivant, dans la vue où il a été marqué</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Point précédent</translation>
    </message>
    <message>
        <source>Go to the previous finding</source>
        <translation>Aller au point repéré précédent</translation>
    </message>
    <message>
        <source>Enter  F2  Del</source>
        <translation>Entrée  F2  Suppr</translation>
    </message>
    <message>
        <source>in the findings: go there, edit, delete</source>
        <translation>points repérés&#x202f;: y aller, modifier, supprimer</translation>
    </message>
    <message>
        <source>Shift+Enter</source>
        <translation>Maj+Entrée</translation>
    </message>
    <message>
        <source>in the findings: play the recording from the marked moment</source>
        <translation>points repérés&#x202f;: lire l’enregistrement depuis le marquage</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json)</source>
        <translation>Annotations 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Export findings</source>
        <translation>Exporter les points</translation>
    </message>
    <message>
        <source>Import findings</source>
        <translation>Importer des points</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json *.json);;All files (*)</source>
        <translation>Annotations 3D Slicer (*.mrk.json *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Mark the touched place, or the place pressed last, in the scene and in the recording</source>
        <translation>Marquer l’endroit touché, ou le dernier endroit où l’on a appuyé, dans la scène et dans l’enregistrement</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marquer</translation>
    </message>
    <message>
        <source>Mark the touched place, or the place pressed last, and write a note on it</source>
        <translation>Marquer l’endroit touché, ou le dernier endroit où l’on a appuyé, et y écrire une note</translation>
    </message>
</context>
<context>
    <name>palpate::app::FingertipPart</name>
    <message>
        <source>Ball, radius %1 mm</source>
        <translation>Boule, rayon %1 mm</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Contact shape: a point feels every facet; a ball slides over small pits like a finger</source>
        <translation>Forme du contact&#x202f;: un point sent chaque facette&#x202f;; une boule glisse sur les petits creux comme un doigt</translation>
    </message>
    <message>
        <source>Fingertip</source>
        <translation>Bout du doigt</translation>
    </message>
    <message>
        <source>fingertip %1 mm ▾</source>
        <translation>bout du doigt %1 mm ▾</translation>
    </message>
    <message>
        <source>fingertip: point ▾</source>
        <translation>bout du doigt&#x202f;: point ▾</translation>
    </message>
    <message>
        <source>%1 mm ▾</source>
        <translation>%1 mm ▾</translation>
    </message>
    <message>
        <source>point ▾</source>
        <translation>point ▾</translation>
    </message>
</context>
<context>
    <name>palpate::app::Help</name>
    <message>
        <source>About Palpate</source>
        <translation>À propos de Palpate</translation>
    </message>
    <message>
        <source>Copied: version, build and system.</source>
        <translation>Copié&#x202f;: version, build et système.</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Documentation</translation>
    </message>
    <message>
        <source>Open the documentation folder: keys, recordings, measures, glossary, devices</source>
        <translation>Ouvrir le dossier de documentation&#x202f;: raccourcis, enregistrements, mesures, glossaire, appareils</translation>
    </message>
    <message>
        <source>Version, build and licences, for bug reports</source>
        <translation>Version, build et licences, pour les rapports de bogue</translation>
    </message>
    <message>
        <source>The documentation was not found next to the program.</source>
        <translation>La documentation n’a pas été trouvée à côté du programme.</translation>
    </message>
    <message>
        <source>No file manager was found. The documentation is in %1</source>
        <translation>Aucun gestionnaire de fichiers trouvé. La documentation est dans %1</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.

Palpate is free software under the BSD 3-Clause licence, built with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause).</source>
        <translation>Recherche, formation et répétition du geste planifié. Pas un dispositif médical.

Palpate est un logiciel libre sous licence BSD à 3 clauses, construit avec Qt (LGPL 3), VTK (BSD à 3 clauses), Eigen (MPL 2.0), SQLite (domaine public), hidapi (BSD) et CLI11 (BSD à 3 clauses).</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Copier pour un rapport de bogue</translation>
    </message>
</context>
<context>
    <name>palpate::app::HelpPart</name>
    <message>
        <source>All keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Show all keys</source>
        <translation>Afficher les raccourcis</translation>
    </message>
    <message>
        <source>Single-letter keys</source>
        <translation>Touches à une lettre</translation>
    </message>
    <message>
        <source>Run commands by single letters. Turn this off for speech input, or if keys are pressed by accident</source>
        <translation>Lancer les commandes par une seule lettre. À désactiver pour la saisie vocale, ou si des touches sont pressées par mégarde</translation>
    </message>
</context>
<context>
    <name>palpate::app::ImagePart</name>
    <message>
        <source>Show an image…</source>
        <translation>Afficher une image…</translation>
    </message>
    <message>
        <source>Show a CT, MR or ultrasound volume in sections</source>
        <translation>Afficher un volume de TDM, d’IRM ou d’échographie dans les coupes</translation>
    </message>
    <message>
        <source>Remove the image</source>
        <translation>Retirer l’image</translation>
    </message>
    <message>
        <source>Show sections without the image; the file is kept</source>
        <translation>Afficher les coupes sans l’image&#x202f;; le fichier est conservé</translation>
    </message>
    <message>
        <source>Show an image</source>
        <translation>Afficher une image</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Images (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>%1 is shown in sections (X).</source>
        <translation>%1 est affiché dans les coupes (X).</translation>
    </message>
    <message>
        <source>%1 lies beside all structures. Do the axes and units of image and meshes agree?</source>
        <translation>%1 se trouve à côté de toutes les structures. Les axes et les unités de l’image et des maillages concordent-ils&#x202f;?</translation>
    </message>
</context>
<context>
    <name>palpate::app::Language</name>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>The new language takes effect when Palpate is restarted.</source>
        <translation>La nouvelle langue s’appliquera au prochain démarrage de Palpate.</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Comme le système</translation>
    </message>
</context>
<context>
    <name>palpate::app::LayerOffers</name>
    <message>
        <source>%1; %2 more are listed in the panel.</source>
        <translation>%1&#x202f;; %2 de plus figurent dans le panneau.</translation>
    </message>
    <message>
        <source>Feel inner structures below outer ones</source>
        <translation>Sentir les structures internes sous les externes</translation>
    </message>
    <message>
        <source>Feel it as a layer</source>
        <translation>Le sentir comme une couche</translation>
    </message>
    <message>
        <source>All in one layer</source>
        <translation>Tout en une couche</translation>
    </message>
    <message>
        <source>Feel all in one layer</source>
        <translation>Tout sentir en une couche</translation>
    </message>
    <message>
        <source>%1 lies in %2, but all structures of this scene are in one layer: %1 cannot be felt through %2.</source>
        <translation>%1 est dans %2, mais toutes les structures de cette scène sont en une seule couche&#x202f;: %1 ne se sent pas à travers %2.</translation>
    </message>
    <message>
        <source>Feel it below</source>
        <translation>Sentir dessous</translation>
    </message>
    <message>
        <source>Added structures lie in or around others. The existing layers were kept.</source>
        <translation>Des structures ajoutées sont dans ou autour d’autres. Les couches existantes ont été gardées.</translation>
    </message>
    <message>
        <source>%1 cannot be felt through %2 yet: %3</source>
        <translation>%1 n’est pas encore perceptible à travers %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>Feel it as a layer below</source>
        <translation>La sentir comme une couche au-dessous</translation>
    </message>
    <message>
        <source>Feel them as layers below</source>
        <translation>Les sentir comme des couches au-dessous</translation>
    </message>
    <message>
        <source>Close the holes</source>
        <translation>Fermer les trous</translation>
    </message>
</context>
<context>
    <name>palpate::app::LegendPart</name>
    <message>
        <source>View › Colour legend shows the legend again.</source>
        <translation>Affichage › Légende des couleurs affiche de nouveau la légende.</translation>
    </message>
    <message>
        <source>Colour legend</source>
        <translation>Légende des couleurs</translation>
    </message>
    <message>
        <source>Show the legend</source>
        <translation>Afficher la légende</translation>
    </message>
    <message>
        <source>Show what the colours in the view mean</source>
        <translation>Afficher la signification des couleurs de la vue</translation>
    </message>
    <message>
        <source>Place of the legend; the mouse can drag it there as well</source>
        <translation>Place de la légende&#x202f;; la souris peut aussi l’y glisser</translation>
    </message>
    <message>
        <source>Where it hides the least</source>
        <translation>Où elle cache le moins</translation>
    </message>
    <message>
        <source>Upper left</source>
        <translation>En haut à gauche</translation>
    </message>
    <message>
        <source>Upper right</source>
        <translation>En haut à droite</translation>
    </message>
    <message>
        <source>Lower left</source>
        <translation>En bas à gauche</translation>
    </message>
    <message>
        <source>Lower right</source>
        <translation>En bas à droite</translation>
    </message>
</context>
<context>
    <name>palpate::app::LumpsPart</name>
    <message>
        <source>What can be felt here</source>
        <translation>Ce qui est palpable ici</translation>
    </message>
    <message>
        <source>Colour organs by the palpability of the lumps below, with a table</source>
        <translation>Colorer les organes selon la palpabilité des nodules en dessous, avec un tableau</translation>
    </message>
    <message>
        <source>What can be felt</source>
        <translation>Ce qui est palpable</translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation>Préparation du toucher</translation>
    </message>
</context>
<context>
    <name>palpate::app::MotionPart</name>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Show or hide the controls of moving tissue</source>
        <translation>Afficher ou masquer les commandes du tissu en mouvement</translation>
    </message>
    <message>
        <source>Hold breath</source>
        <translation>Retenir le souffle</translation>
    </message>
    <message>
        <source>Hold breathing tissue where it is</source>
        <translation>Arrêter le tissu qui respire où il est</translation>
    </message>
</context>
<context>
    <name>palpate::app::Notices</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Show or hide the list of all messages and file notes since the start</source>
        <translation>Afficher ou masquer la liste des messages et des remarques sur les fichiers depuis le début</translation>
    </message>
</context>
<context>
    <name>palpate::app::PeekPart</name>
    <message>
        <source>Peek inside</source>
        <translation>Regarder à l’intérieur</translation>
    </message>
    <message>
        <source>Make everything above the touched structure, or else the selected one, nearly transparent; or hold G</source>
        <translation>Rendre presque transparent tout ce qui recouvre la structure touchée, ou sinon la structure sélectionnée&#x202f;; ou maintenir G</translation>
    </message>
    <message>
        <source>hold G</source>
        <translation>maintenir G</translation>
    </message>
    <message>
        <source>look through what is above the structure</source>
        <translation>voir à travers ce qui recouvre la structure</translation>
    </message>
    <message>
        <source>Peek: touch or select the structure that you want to see.</source>
        <translation>Regarder à l’intérieur&#x202f;: touchez ou sélectionnez la structure à voir.</translation>
    </message>
    <message>
        <source>Peek: nothing is above %1.</source>
        <translation>Regarder à l’intérieur&#x202f;: rien ne recouvre %1.</translation>
    </message>
</context>
<context>
    <name>palpate::app::PicturePart</name>
    <message>
        <source>Snapshot</source>
        <translation>Photo</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Cadrer le tout dans la vue</translation>
    </message>
    <message>
        <source>%1: the picture could not be written. Is the folder writable and the disk not full?</source>
        <translation>%1&#x202f;: l’image n’a pas pu être écrite. Le dossier est-il accessible en écriture, et le disque non plein&#x202f;?</translation>
    </message>
    <message>
        <source>Save a picture of the view with a caption, and copy it</source>
        <translation>Enregistrer une image de la vue avec une légende, et la copier</translation>
    </message>
    <message>
        <source>Picture copied, and saved to %1</source>
        <translation>Image copiée et enregistrée dans %1</translation>
    </message>
    <message>
        <source>Standard views</source>
        <translation>Vues standard</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReceivedSurfaces</name>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>A surface was not received: several others are still being stored. Send it again.</source>
        <translation>Une surface n’a pas été reçue&#x202f;: plusieurs autres sont encore en cours d’enregistrement. Envoyez-la de nouveau.</translation>
    </message>
    <message>
        <source>%1 surfaces were received. Further ones are ignored until Palpate is started again.</source>
        <translation>%1 surfaces ont été reçues. Les suivantes sont ignorées jusqu’au prochain démarrage de Palpate.</translation>
    </message>
</context>
<context>
    <name>palpate::app::RecordingPart</name>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Record the motion and the force of the hand</source>
        <translation>Enregistrer le mouvement et la force de la main</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation>Lire ou suspendre l’enregistrement</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>Return to the start of the recording</source>
        <translation>Revenir au début de l’enregistrement</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Enregistrement %1</translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>Results…</source>
        <translation>Résultats…</translation>
    </message>
    <message>
        <source>Open the recording</source>
        <translation>Ouvrir l’enregistrement</translation>
    </message>
    <message>
        <source>The fingertip is a ball of %1 mm radius, as in the recording (Session › Fingertip).</source>
        <translation>Le bout du doigt est, comme à l’enregistrement, une boule de %1 mm de rayon (Séance › Bout du doigt).</translation>
    </message>
    <message>
        <source>The fingertip is a point, as in the recording (Session › Fingertip).</source>
        <translation>Le bout du doigt est, comme à l’enregistrement, un point (Séance › Bout du doigt).</translation>
    </message>
    <message>
        <source>Find the meshes…</source>
        <translation>Chercher les maillages…</translation>
    </message>
    <message>
        <source>Meshes of the recording</source>
        <translation>Maillages de l’enregistrement</translation>
    </message>
    <message>
        <source>Record to another folder…</source>
        <translation>Enregistrer dans un autre dossier…</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly while recording %1. The first %2 s were saved.</source>
        <translation>Palpate s’est arrêté de façon inattendue pendant l’enregistrement %1. Les premières %2 s sont enregistrées.</translation>
    </message>
    <message>
        <source>Do not offer again</source>
        <translation>Ne plus proposer</translation>
    </message>
    <message>
        <source>%1: a recording names what was touched. Open it after the exercise.</source>
        <translation>%1&#x202f;: un enregistrement nomme ce qui a été touché. Ouvrez-le après l’exercice.</translation>
    </message>
    <message>
        <source>%1 can be played, but its meshes were not found: only the path of the hand is shown. Open the meshes to see what was touched.</source>
        <translation>%1 peut être lu, mais ses maillages n’ont pas été trouvés&#x202f;: seul le trajet de la main est affiché. Ouvrez les maillages pour voir ce qui a été touché.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportDialog</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>The report contains views, findings, lumps, distances and the force of the open recording. Both fields may stay empty.</source>
        <translation>Le rapport contient vues, points repérés, nodules, distances et force de l’enregistrement ouvert. Les deux champs peuvent rester vides.</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>Écrire le rapport…</translation>
    </message>
    <message>
        <source>&amp;Case</source>
        <translation>&amp;Cas</translation>
    </message>
    <message>
        <source>&amp;Examiner</source>
        <translation>&amp;Examinateur</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportPart</name>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Write a report of the recording as PDF or web page</source>
        <translation>Écrire un rapport de l’enregistrement en PDF ou page web</translation>
    </message>
    <message>
        <source>PDF for printing (*.pdf)</source>
        <translation>PDF à imprimer (*.pdf)</translation>
    </message>
    <message>
        <source>Web page, for screen readers too (*.html)</source>
        <translation>Page web, aussi pour lecteurs d’écran (*.html)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Nothing was written: %1 already exists. Enter the full file name to replace the file.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 existe déjà. Pour remplacer le fichier, saisir le nom complet.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 must end in .pdf or .html.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 doit finir par .pdf ou .html.</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Rapport écrit dans %1</translation>
    </message>
    <message>
        <source>Report cancelled</source>
        <translation>Rapport annulé</translation>
    </message>
    <message>
        <source>Report written to %1; it lists the missing parts</source>
        <translation>Rapport écrit dans %1&#x202f;; il indique ce qui manque</translation>
    </message>
    <message>
        <source>The report describes a finished recording.</source>
        <translation>Le rapport décrit un enregistrement terminé.</translation>
    </message>
    <message>
        <source>Stop and report…</source>
        <translation>Arrêter et rapporter…</translation>
    </message>
    <message>
        <source>The report describes a recording: record, press, mark findings and stop. Then choose Report again.</source>
        <translation>Le rapport décrit un enregistrement&#x202f;: enregistrer, appuyer, marquer des points et arrêter. Choisir ensuite Rapport de nouveau.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Ouvrir le rapport</translation>
    </message>
    <message>
        <source>No program was found that opens %1.</source>
        <translation>Aucun programme capable d’ouvrir %1 n’a été trouvé.</translation>
    </message>
    <message numerus="yes">
        <source>Report written to %1; %n finding(s) marked outside of the recording are in a table of their own</source>
        <translation>
            <numerusform>Rapport écrit dans %1&#x202f;; %n point marqué hors de l’enregistrement est dans un tableau à part</numerusform>
            <numerusform>Rapport écrit dans %1&#x202f;; %n points marqués hors de l’enregistrement sont dans un tableau à part</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportRun</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
</context>
<context>
    <name>palpate::app::ResultsPart</name>
    <message>
        <source>Results…</source>
        <translation>Résultats…</translation>
    </message>
    <message>
        <source>Show and export forces, coverage and findings of the recording</source>
        <translation>Afficher et exporter forces, couverture et points repérés de l’enregistrement</translation>
    </message>
    <message>
        <source>Store the surfaces in recordings</source>
        <translation>Stocker les surfaces dans les enregistrements</translation>
    </message>
    <message>
        <source>A recording then contains the whole session and grows by the size of the meshes</source>
        <translation>Un enregistrement contient alors toute la séance et grossit de la taille des maillages</translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneChanges</name>
    <message>
        <source>1 note on these files</source>
        <translation>1 remarque sur ces fichiers</translation>
    </message>
    <message>
        <source>%1 notes on these files</source>
        <translation>%1 remarques sur ces fichiers</translation>
    </message>
    <message>
        <source>%1  ·  %2 (F4 lists them)</source>
        <translation>%1  ·  %2 (F4 les liste)</translation>
    </message>
    <message>
        <source>The meshes were read again with coordinates %1. Tissue and findings are kept; earlier changes cannot be undone.</source>
        <translation>Les maillages ont été relus avec les coordonnées %1. Tissus et points repérés sont gardés&#x202f;; les changements antérieurs ne peuvent plus être annulés.</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1&#x202f;: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 was added to the scene.</source>
        <translation>Ajout à la scène&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 structures were added to the scene.</source>
        <translation>%1 structures ont été ajoutées à la scène.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Add %1 structures</source>
        <translation>Ajouter %1 structures</translation>
    </message>
    <message>
        <source>%1 structures: %2 (%3 and others; the sign in the list of structures has the details)</source>
        <translation>%1 structures&#x202f;: %2 (%3 et d’autres&#x202f;; détails sur le signe dans la liste des structures)</translation>
    </message>
    <message>
        <source>The scene has an exercise. Its targets are shown, because a recording is opened.</source>
        <translation>La scène contient un exercice. Ses cibles sont montrées, car un enregistrement est ouvert.</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) on hidden targets are withheld</source>
        <translation>
            <numerusform>%n remarque sur les cibles cachées est retenue</numerusform>
            <numerusform>%n remarques sur les cibles cachées sont retenues</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneFiles</name>
    <message>
        <source>Opening was cancelled.</source>
        <translation>Ouverture interrompue.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open meshes, a scene or a recording</source>
        <translation>Ouvrir des maillages, une scène ou un enregistrement</translation>
    </message>
    <message>
        <source>Add to the scene…</source>
        <translation>Ajouter à la scène…</translation>
    </message>
    <message>
        <source>Add meshes or a scene to the open scene</source>
        <translation>Ajouter des maillages ou une scène à la scène ouverte</translation>
    </message>
    <message>
        <source>Close the scene</source>
        <translation>Fermer la scène</translation>
    </message>
    <message>
        <source>Close the open scene</source>
        <translation>Fermer la scène ouverte</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>Add %1 to the open scene?</source>
        <translation>Ajouter %1 à la scène ouverte&#x202f;?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Open instead</source>
        <translation>Ouvrir seul</translation>
    </message>
    <message>
        <source>The phantom was not found next to the program.</source>
        <translation>Le fantôme est introuvable à côté du programme.</translation>
    </message>
    <message>
        <source>This anatomy is only %1 mm across. Its coordinates are probably in metres.</source>
        <translation>Cette anatomie ne mesure que %1 mm. Ses coordonnées sont sans doute en mètres.</translation>
    </message>
    <message>
        <source>Read as metres</source>
        <translation>Lire en mètres</translation>
    </message>
    <message>
        <source>Open anatomy</source>
        <translation>Ouvrir une anatomie</translation>
    </message>
    <message>
        <source>Anatomy, scenes and recordings (%1);;All files (*)</source>
        <translation>Anatomie, scènes et enregistrements (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Add to the scene</source>
        <translation>Ajouter à la scène</translation>
    </message>
    <message>
        <source>%1 has points of 3D Slicer, which become findings. Open the anatomy first, or both at once.</source>
        <translation>%1 contient des points de 3D Slicer, qui deviennent des observations. Ouvrez d’abord l’anatomie, ou les deux à la fois.</translation>
    </message>
    <message>
        <source>%1: is it an image of the open scene, or a segmentation?</source>
        <translation>%1&#x202f;: est-ce une image de la scène ouverte ou une segmentation&#x202f;?</translation>
    </message>
    <message>
        <source>Show the image</source>
        <translation>Afficher l’image</translation>
    </message>
    <message>
        <source>Open the segmentation</source>
        <translation>Ouvrir la segmentation</translation>
    </message>
    <message>
        <source>Some of the files are cut off.</source>
        <translation>Certains des fichiers sont tronqués.</translation>
    </message>
    <message>
        <source>Open the part that is there</source>
        <translation>Ouvrir la partie présente</translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneSurfaces</name>
    <message>
        <source>Computing the surface of %1…</source>
        <translation>Calcul de la surface de %1…</translation>
    </message>
    <message>
        <source>The map of %1 was applied.</source>
        <translation>La carte de %1 a été appliquée.</translation>
    </message>
    <message>
        <source>Reading the maps of %1…</source>
        <translation>Lecture des cartes de %1…</translation>
    </message>
    <message>
        <source>The surface of %1 was replaced.</source>
        <translation>La surface de %1 a été remplacée.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 has voxel steps of about %2, which can be felt.</source>
        <translation>%1 a des marches de voxels d’environ %2, que l’on sent.</translation>
    </message>
    <message>
        <source>%1 surfaces have voxel steps of about %2, which can be felt.</source>
        <translation>%1 surfaces ont des marches de voxels d’environ %2, que l’on sent.</translation>
    </message>
    <message>
        <source>Smooth it</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Smooth them</source>
        <translation>Les lisser</translation>
    </message>
    <message>
        <source>%1 is inside out: it can be felt only from inside.</source>
        <translation>%1 est à l’envers et ne se sent que de l’intérieur.</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out: they can be felt only from inside.</source>
        <translation>%1 surfaces sont à l’envers et ne se sentent que de l’intérieur.</translation>
    </message>
    <message>
        <source>Turn it around</source>
        <translation>La retourner</translation>
    </message>
    <message>
        <source>Turn them around</source>
        <translation>Les retourner</translation>
    </message>
</context>
<context>
    <name>palpate::app::SectionPart</name>
    <message>
        <source>axial, %1 mm superior</source>
        <translation>axiale, %1 mm crânial</translation>
    </message>
    <message>
        <source>axial, %1 mm inferior</source>
        <translation>axiale, %1 mm caudal</translation>
    </message>
    <message>
        <source>coronal, %1 mm posterior</source>
        <translation>coronale, %1 mm postérieur</translation>
    </message>
    <message>
        <source>coronal, %1 mm anterior</source>
        <translation>coronale, %1 mm antérieur</translation>
    </message>
    <message>
        <source>sagittal, %1 mm left</source>
        <translation>sagittale, %1 mm à gauche</translation>
    </message>
    <message>
        <source>sagittal, %1 mm right</source>
        <translation>sagittale, %1 mm à droite</translation>
    </message>
    <message>
        <source>free, %1 mm deeper</source>
        <translation>libre, %1 mm plus profond</translation>
    </message>
    <message>
        <source>free, %1 mm nearer</source>
        <translation>libre, %1 mm plus proche</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Cut the picture through the hand, the selected finding or the middle of the view; the hand still feels everything</source>
        <translation>Couper l’image au niveau de la main, du repère sélectionné ou du milieu de la vue&#x202f;; la main sent toujours tout</translation>
    </message>
    <message>
        <source>Next direction of the section</source>
        <translation>Direction suivante de la coupe</translation>
    </message>
    <message>
        <source>Axial, coronal, sagittal, or facing the viewer</source>
        <translation>Axiale, coronale, sagittale ou face à l’observateur</translation>
    </message>
    <message>
        <source>Other side of the section</source>
        <translation>Autre côté de la coupe</translation>
    </message>
    <message>
        <source>Show the side that is hidden</source>
        <translation>Montrer le côté masqué</translation>
    </message>
    <message>
        <source>Section through the hand</source>
        <translation>Coupe au niveau de la main</translation>
    </message>
    <message>
        <source>Move the section to the hand, the selected finding or the middle of the view</source>
        <translation>Déplacer la coupe vers la main, le repère sélectionné ou le milieu de la vue</translation>
    </message>
    <message>
        <source>Section deeper</source>
        <translation>Coupe plus profonde</translation>
    </message>
    <message>
        <source>Move the section away from the viewer</source>
        <translation>Éloigner la coupe de l’observateur</translation>
    </message>
    <message>
        <source>Section nearer</source>
        <translation>Coupe plus proche</translation>
    </message>
    <message>
        <source>Move the section towards the viewer</source>
        <translation>Rapprocher la coupe de l’observateur</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Maj+molette</translation>
    </message>
    <message>
        <source>move the section</source>
        <translation>déplacer la coupe</translation>
    </message>
    <message>
        <source>%1 · cuts no visible structure</source>
        <translation>%1 · ne coupe aucune structure visible</translation>
    </message>
    <message>
        <source>%1 · the hand still feels everything</source>
        <translation>%1 · la main sent toujours tout</translation>
    </message>
    <message>
        <source>Section along the finger</source>
        <translation>Coupe le long du doigt</translation>
    </message>
    <message>
        <source>Small picture of the hand and of what lies below, live and in playback</source>
        <translation>Petite image de la main et de ce qui se trouve dessous, en direct et à la lecture</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Plan de coupe</translation>
    </message>
</context>
<context>
    <name>palpate::app::SelfTestDialog</name>
    <message>
        <source>Device test</source>
        <translation>Test de l’appareil</translation>
    </message>
    <message>
        <source>For about one minute, small forces move the handle, and virtual walls of rising stiffness press against your hand with up to %1 N. The test measures round trip, noise, friction and the stiffness that %2 holds without vibrating. Clear the space around the handle. You can stop the test at any time; the wall is withdrawn at the first sign of instability.</source>
        <translation>Pendant environ une minute, de petites forces déplacent la poignée et des parois virtuelles de raideur croissante appuient contre votre main avec au plus %1 N. Le test mesure le temps d’aller-retour, le bruit, le frottement et la raideur que %2 tient sans vibrer. Dégagez l’espace autour de la poignée. Vous pouvez interrompre le test à tout moment&#x202f;; la paroi est retirée au premier signe d’instabilité.</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Avancement du test</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Démarrer le test</translation>
    </message>
    <message>
        <source>Save the page…</source>
        <translation>Enregistrer la page…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Folder for the page</source>
        <translation>Dossier pour la page</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShareDialog</name>
    <message>
        <source>Not encrypted and without a password: everyone in this network can read the touch and the findings.</source>
        <translation>Ni chiffrement ni mot de passe&#x202f;: tout le monde sur ce réseau peut lire le toucher et les observations.</translation>
    </message>
    <message>
        <source>&amp;Add surfaces that 3D Slicer sends to the scene</source>
        <translation>&amp;Ajouter à la scène les surfaces envoyées par 3D Slicer</translation>
    </message>
    <message>
        <source>Share with 3D Slicer</source>
        <translation>Partager avec 3D Slicer</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>Cet ordinateur seulement</translation>
    </message>
    <message>
        <source>All computers in the network</source>
        <translation>Tous les ordinateurs du réseau</translation>
    </message>
    <message>
        <source>Stored in %1, for this user only</source>
        <translation>Enregistrées dans %1, pour cet utilisateur seulement</translation>
    </message>
    <message>
        <source>Start sharing</source>
        <translation>Commencer le partage</translation>
    </message>
    <message>
        <source>Sends the hand, the touched point, the force and the findings by OpenIGTLink. In 3D Slicer, open the module OpenIGTLinkIF, add a connector of type Client with this port and the host name localhost (on another computer: the address of this one), and activate it.</source>
        <translation>Envoie la main, le point touché, la force et les observations par OpenIGTLink. Dans 3D Slicer, ouvrez le module OpenIGTLinkIF, ajoutez un connecteur de type Client avec ce port et le nom d’hôte localhost (sur un autre ordinateur&#x202f;: l’adresse de celui-ci), puis activez-le.</translation>
    </message>
    <message>
        <source>&amp;Reachable from</source>
        <translation>Accessible &amp;depuis</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Stop sharing</source>
        <translation>Arrêter le partage</translation>
    </message>
    <message>
        <source>Not shared.</source>
        <translation>Non partagé.</translation>
    </message>
    <message>
        <source>Waiting for 3D Slicer at port %1.</source>
        <translation>En attente de 3D Slicer sur le port %1.</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>Connecté&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 messages a second</source>
        <translation>%1 messages par seconde</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) not sent, because the receiver is too slow</source>
        <translation>
            <numerusform>%n message non envoyé, car le destinataire est trop lent</numerusform>
            <numerusform>%n messages non envoyés, car le destinataire est trop lent</numerusform>
        </translation>
    </message>
    <message>
        <source>Latest error: %1</source>
        <translation>Dernière erreur&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>palpate::app::SharePart</name>
    <message>
        <source>Sharing</source>
        <translation>Partage</translation>
    </message>
    <message>
        <source>Share with 3D Slicer…</source>
        <translation>Partager avec 3D Slicer…</translation>
    </message>
    <message>
        <source>Send the touch and the findings to 3D Slicer and receive surfaces, by OpenIGTLink</source>
        <translation>Envoyer le toucher et les observations à 3D Slicer et recevoir des surfaces, par OpenIGTLink</translation>
    </message>
    <message>
        <source>sharing</source>
        <translation>partage actif</translation>
    </message>
    <message>
        <source>shared with 3D Slicer</source>
        <translation>partagé avec 3D Slicer</translation>
    </message>
    <message>
        <source>OpenIGTLink server at port %1. To stop it: Device › Share with 3D Slicer…</source>
        <translation>Serveur OpenIGTLink sur le port %1. Pour l’arrêter&#x202f;: Périphérique › Partager avec 3D Slicer…</translation>
    </message>
    <message>
        <source>%1 was received from 3D Slicer.</source>
        <translation>%1 a été reçu de 3D Slicer.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShowAround</name>
    <message>
        <source>Show me around</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>This is a practice liver with lumps inside.</source>
        <translation>Voici un foie d’exercice qui contient des nodules.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Press to feel</source>
        <translation>Appuyer pour sentir</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Short tour of the window, with the practice liver if no scene is open</source>
        <translation>Brève visite de la fenêtre, avec le foie d’exercice si aucune scène n’est ouverte</translation>
    </message>
    <message>
        <source>The tour uses the open scene and changes nothing.</source>
        <translation>La visite utilise la scène ouverte et n’y change rien.</translation>
    </message>
    <message>
        <source>The list shows all structures. The eye shows or hides a structure; the hand makes a structure palpable or not. Below the list you set how the structure feels.</source>
        <translation>La liste contient toutes les structures. L’œil affiche ou masque une structure&#x202f;; la main la rend palpable ou non. Sous la liste, on règle comment la structure se sent.</translation>
    </message>
    <message>
        <source>Force in newtons, touched structure, depth in millimetres and a chart of the last ten seconds. At the same depth, stiffer tissue pushes back harder.</source>
        <translation>Force en newtons, structure touchée, profondeur en millimètres et courbe des dix dernières secondes. À profondeur égale, un tissu plus raide repousse plus fort.</translation>
    </message>
    <message>
        <source>Recording and findings</source>
        <translation>Enregistrement et points repérés</translation>
    </message>
    <message>
        <source>Click Palpate (P), then drag on the anatomy to press and slide; the wheel sets the depth. With the keyboard: Ctrl and the arrow keys move the press point, Enter presses, Page Down goes deeper. Esc releases.</source>
        <translation>Cliquer sur Palper (P), puis glisser sur l’anatomie pour appuyer et glisser&#x202f;; la molette règle la profondeur. Au clavier&#x202f;: Ctrl et les flèches déplacent le point d’appui, Entrée appuie, Page suivante va plus profond. Échap relâche.</translation>
    </message>
    <message>
        <source>Record (R) starts and stops a recording. Mark (M) marks the touched place, or the place pressed last, as a finding with force and depth, listed here; F2 renames the finding. File › Report… writes a recording with findings, distances and margins as PDF.</source>
        <translation>Enregistrer (R) démarre et arrête un enregistrement. Marquer (M) marque l’endroit touché, ou le dernier endroit où l’on a appuyé, comme point repéré avec force et profondeur, listé ici&#x202f;; F2 le renomme. Fichier › Rapport… écrit un enregistrement avec points repérés, distances et marges en PDF.</translation>
    </message>
</context>
<context>
    <name>palpate::app::SoundChoice</name>
    <message>
        <source>Touch sound</source>
        <translation>Son du toucher</translation>
    </message>
    <message>
        <source>Play a tone: higher pitch for stiffer tissue, louder for more force</source>
        <translation>Jouer un son&#x202f;: plus aigu pour un tissu plus raide, plus fort pour une force plus grande</translation>
    </message>
    <message>
        <source>Touch sound stopped: the loudspeaker was disconnected.</source>
        <translation>Son du toucher arrêté&#x202f;: le haut-parleur a été déconnecté.</translation>
    </message>
    <message>
        <source>Touch sound (%1)</source>
        <translation>Son du toucher (%1)</translation>
    </message>
</context>
<context>
    <name>palpate::app::StatusProgress</name>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Cancel; the open scene does not change</source>
        <translation>Interrompre&#x202f;; la scène ouverte ne change pas</translation>
    </message>
</context>
<context>
    <name>palpate::app::StructuresPart</name>
    <message>
        <source>Find a structure…</source>
        <translation>Chercher une structure…</translation>
    </message>
    <message>
        <source>List only structures with these words in their names</source>
        <translation>Ne lister que les structures dont le nom contient ces mots</translation>
    </message>
    <message>
        <source>Rename the structure…</source>
        <translation>Renommer la structure…</translation>
    </message>
    <message>
        <source>Rename the selected structure</source>
        <translation>Renommer la structure choisie</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Retirer de la scène</translation>
    </message>
    <message>
        <source>Remove the selected structures from the scene; their files are kept</source>
        <translation>Retirer les structures choisies de la scène&#x202f;; leurs fichiers sont conservés</translation>
    </message>
    <message>
        <source>Ctrl+E  Ctrl+H</source>
        <translation>Ctrl+E  Ctrl+H</translation>
    </message>
    <message>
        <source>show or hide, turn touch on or off</source>
        <translation>afficher ou masquer, activer ou non le toucher</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>lettres</translation>
    </message>
    <message>
        <source>go to the structure whose name starts with them</source>
        <translation>aller à la structure dont le nom commence ainsi</translation>
    </message>
    <message>
        <source>F2  Del</source>
        <translation>F2  Suppr</translation>
    </message>
    <message>
        <source>rename, remove from the scene</source>
        <translation>renommer, retirer de la scène</translation>
    </message>
    <message>
        <source>Ctrl+↓  ↑</source>
        <translation>Ctrl+↓  ↑</translation>
    </message>
    <message>
        <source>move one layer deeper or outwards</source>
        <translation>déplacer d’une couche vers l’intérieur ou l’extérieur</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Structures in colour-blind colours</source>
        <translation>Structures en couleurs pour daltoniens</translation>
    </message>
    <message>
        <source>Give lumps, arteries, portal vein, other veins, ducts and organs colours that colour-blind people can distinguish; also when meshes are opened</source>
        <translation>Donner aux nodules, aux artères, à la veine porte, aux autres veines, aux conduits et aux organes des couleurs que les daltoniens distinguent&#x202f;; aussi à l’ouverture de maillages</translation>
    </message>
    <message>
        <source>Colour structures</source>
        <translation>Colorer les structures</translation>
    </message>
</context>
<context>
    <name>palpate::app::ThresholdDialog</name>
    <message>
        <source>The &amp;first was stiffer</source>
        <translation>Le &amp;premier était plus rigide</translation>
    </message>
    <message>
        <source>The &amp;second was stiffer</source>
        <translation>Le &amp;second était plus rigide</translation>
    </message>
    <message>
        <source>Delete the stored threshold</source>
        <translation>Supprimer le seuil enregistré</translation>
    </message>
    <message>
        <source>Also give verdicts on lumps for my hand</source>
        <translation>Donner aussi les verdicts sur les nodules pour ma main</translation>
    </message>
    <message>
        <source>My threshold</source>
        <translation>Mon seuil</translation>
    </message>
    <message>
        <source>%v of %m trials</source>
        <translation>%v sur %m essais</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>After “plainly felt”, “felt by a trained hand” and “too little for a trained hand”: whether the change of stiffness is above the stored threshold</source>
        <translation>Après «&#x202f;nettement palpable&#x202f;», «&#x202f;palpable par une main exercée&#x202f;» et «&#x202f;trop peu pour une main exercée&#x202f;»&#x202f;: si le changement de rigidité dépasse le seuil enregistré</translation>
    </message>
    <message>
        <source>Interrupted after %1 trials. An estimate needs at least %2; nothing was changed.</source>
        <translation>Interrompu après %1 essais. Une estimation en demande au moins %2&#x202f;; rien n’a été changé.</translation>
    </message>
    <message>
        <source>Done. Your threshold is below.</source>
        <translation>Terminé. Votre seuil est ci-dessous.</translation>
    </message>
    <message>
        <source>Interrupt</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Which of two presses is stiffer? In each of 60 trials you press an invisible wall twice and tell which press was stiffer. The difference becomes smaller until you can only guess. It takes about 8 minutes.</source>
        <translation>Laquelle de deux pressions est plus rigide&#x202f;? À chacun des 60 essais, vous appuyez deux fois sur un mur invisible et indiquez quelle pression était plus rigide. La différence diminue jusqu’à ce que vous ne puissiez que deviner. Cela dure environ 8 minutes.</translation>
    </message>
    <message>
        <source>This needs a device that renders force, with an open scene: with the mouse nothing is felt. Choose one in the menu Device.</source>
        <translation>Il faut un appareil qui rend la force et une scène ouverte&#x202f;: avec la souris, on ne sent rien. Choisissez-en un dans le menu Appareil.</translation>
    </message>
    <message>
        <source>First press: push away from you onto the wall, then move back.</source>
        <translation>Première pression&#x202f;: poussez le mur loin de vous, puis revenez.</translation>
    </message>
    <message>
        <source>Second press: push onto the wall again, then move back.</source>
        <translation>Seconde pression&#x202f;: poussez de nouveau le mur, puis revenez.</translation>
    </message>
    <message>
        <source>Which press was stiffer? Guess if you are not sure.</source>
        <translation>Quelle pression était plus rigide&#x202f;? Devinez si vous n’êtes pas sûr.</translation>
    </message>
    <message>
        <source>Your threshold: Weber fraction %1 (95 % interval %2 to %3 %), from %4 trials with %5. This increase of stiffness is told apart in 71 % of the trials.</source>
        <translation>Votre seuil&#x202f;: fraction de Weber %1 (intervalle à 95 %&#x202f;: %2 à %3 %), d’après %4 essais avec %5. Cette augmentation de rigidité est reconnue dans 71 % des essais.</translation>
    </message>
    <message>
        <source>No threshold of your own is stored.</source>
        <translation>Aucun seuil personnel n’est enregistré.</translation>
    </message>
</context>
<context>
    <name>palpate::app::TissueOffer</name>
    <message>
        <source>The tissue of %1 was chosen by its name.</source>
        <translation>%1&#x202f;: tissu choisi d’après le nom.</translation>
    </message>
    <message>
        <source>The tissue of %1 structures was chosen by their names.</source>
        <translation>%1 structures&#x202f;: tissu choisi d’après leur nom.</translation>
    </message>
    <message numerus="yes">
        <source>No preset matches the name of %n: “Firm organ”, 0.5 N/mm.</source>
        <translation>
            <numerusform>Aucun préréglage d’après le nom pour %n&#x202f;: «&#x202f;organe ferme&#x202f;», 0,5 N/mm.</numerusform>
            <numerusform>Aucun préréglage d’après le nom pour %n&#x202f;: «&#x202f;organe ferme&#x202f;», 0,5 N/mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tissue by name</source>
        <translation>Tissus selon le nom</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Restore tissue</source>
        <translation>Rétablir les tissus</translation>
    </message>
    <message>
        <source>Choose the tissue of unknown names</source>
        <translation>Choisir le tissu des noms inconnus</translation>
    </message>
    <message>
        <source>Choose for all…</source>
        <translation>Choisir pour toutes…</translation>
    </message>
    <message>
        <source>Vessels, nerves and ducts that are not felt: %1.</source>
        <translation>Vaisseaux, nerfs et conduits qui ne sont pas palpés&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Opacities chosen by name: %1.</source>
        <translation>Opacités choisies d’après le nom&#x202f;: %1.</translation>
    </message>
</context>
<context>
    <name>palpate::app::TouchMapPart</name>
    <message>
        <source>Map of touch</source>
        <translation>Carte du toucher</translation>
    </message>
    <message>
        <source>Next map of touch</source>
        <translation>Carte du toucher suivante</translation>
    </message>
    <message>
        <source>Previous map of touch</source>
        <translation>Carte du toucher précédente</translation>
    </message>
    <message>
        <source>Map of touch: %1</source>
        <translation>Carte du toucher&#x202f;: %1</translation>
    </message>
    <message>
        <source>Colour the examined surface, in the recording up to the moment shown, or live</source>
        <translation>Colorer la surface examinée, dans l’enregistrement jusqu’au moment affiché, ou en direct</translation>
    </message>
</context>
<context>
    <name>palpate::app::TouchPart</name>
    <message>
        <source>Use of the pointer or the device</source>
        <translation>Usage du pointeur ou de l’appareil</translation>
    </message>
    <message>
        <source>The pointer turns the view, or presses this far along the line of sight [mm] or with this force [N]. The wheel sets the value; P switches between the two</source>
        <translation>Le pointeur tourne la vue, ou appuie de tant le long du regard [mm] ou avec cette force [N]. La molette règle la valeur&#x202f;; P passe de l’un à l’autre</translation>
    </message>
    <message>
        <source>Palpate</source>
        <translation>Palper</translation>
    </message>
    <message>
        <source>Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera</source>
        <translation>Palper avec le pointeur&#x202f;: glisser pour appuyer, molette pour la profondeur ou l’effort&#x202f;; sinon le pointeur déplace la caméra</translation>
    </message>
    <message>
        <source>hold Space</source>
        <translation>tenir Espace</translation>
    </message>
    <message>
        <source>palpate while the key is held</source>
        <translation>palper tant que la touche est tenue</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>glisser</translation>
    </message>
    <message>
        <source>camera: rotate · palpate: press and slide</source>
        <translation>caméra&#x202f;: tourner · palper&#x202f;: appuyer et glisser</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>camera: select the structure (with Ctrl: add to the selection)</source>
        <translation>caméra&#x202f;: choisir la structure (avec Ctrl&#x202f;: ajouter à la sélection)</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>glisser droit</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: rotate</source>
        <translation>caméra&#x202f;: zoomer · palper&#x202f;: tourner</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>glisser milieu</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>déplacer</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)</source>
        <translation>caméra&#x202f;: zoomer · palper&#x202f;: profondeur en mm, ou effort en N (avec Ctrl&#x202f;: zoomer)</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>double-clic</translation>
    </message>
    <message>
        <source>centre the view on the point</source>
        <translation>centrer la vue sur le point</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Lâcher</translation>
    </message>
    <message>
        <source>lift the hand, then return to the camera</source>
        <translation>lever la main, puis revenir à la caméra</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Touching with the %1</source>
        <translation>Toucher avec&#x202f;: %1</translation>
    </message>
    <message>
        <source>Turning the view</source>
        <translation>Rotation de la vue</translation>
    </message>
</context>
<context>
    <name>palpate::app::ViewPart</name>
    <message>
        <source>Dent under the finger</source>
        <translation>Creux sous le doigt</translation>
    </message>
    <message>
        <source>Draw soft tissue deformed at the contact, with a fine grid</source>
        <translation>Dessiner le tissu mou déformé au contact, avec une fine grille</translation>
    </message>
    <message>
        <source>From the front (A)</source>
        <translation>De face (A)</translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation>De dos (P)</translation>
    </message>
    <message>
        <source>From the left (L)</source>
        <translation>De la gauche (L)</translation>
    </message>
    <message>
        <source>From the right (R)</source>
        <translation>De la droite (R)</translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation>De la tête (S)</translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation>Des pieds (I)</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Oblique</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ActionList</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ChipRow</name>
    <message>
        <source>More status</source>
        <translation>Autres indications</translation>
    </message>
    <message>
        <source>Status items that do not fit in this row</source>
        <translation>Indications qui ne tiennent pas dans cette ligne</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ConnectedDevices</name>
    <message>
        <source>3D Systems Touch, Phantom</source>
        <translation>3D Systems Touch, Phantom</translation>
    </message>
    <message>
        <source>Force Dimension omega, delta, sigma, lambda</source>
        <translation>Force Dimension omega, delta, sigma, lambda</translation>
    </message>
    <message>
        <source>Haply Inverse3, Minverse</source>
        <translation>Haply Inverse3, Minverse</translation>
    </message>
    <message>
        <source>WoodenHaptics, Polhem</source>
        <translation>WoodenHaptics, Polhem</translation>
    </message>
    <message>
        <source>SpaceMouse (input only)</source>
        <translation>SpaceMouse (entrée seule)</translation>
    </message>
    <message>
        <source>Tracked hand by OpenIGTLink (input only)</source>
        <translation>Main suivie par OpenIGTLink (entrée seule)</translation>
    </message>
    <message>
        <source>driver not usable</source>
        <translation>pilote inutilisable</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>connected: %1</source>
        <translation>branché&#x202f;: %1</translation>
    </message>
    <message>
        <source>Choose Device › %1.</source>
        <translation>Choisissez Appareil › %1.</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>pas prêt</translation>
    </message>
    <message>
        <source>connected, not ready: %1</source>
        <translation>branché, pas prêt&#x202f;: %1</translation>
    </message>
    <message>
        <source>It needs %1.</source>
        <translation>Il lui faut %1.</translation>
    </message>
    <message>
        <source>supported; the maker&apos;s library is missing</source>
        <translation>pris en charge&#x202f;; la bibliothèque du fabricant manque</translation>
    </message>
    <message>
        <source>driver cannot start</source>
        <translation>le pilote ne peut pas démarrer</translation>
    </message>
    <message>
        <source>supported; none is connected</source>
        <translation>pris en charge&#x202f;; aucun n’est branché</translation>
    </message>
    <message>
        <source>driver not installed</source>
        <translation>pilote non installé</translation>
    </message>
    <message>
        <source>Install the plugin “%1”, a part of Palpate.</source>
        <translation>Installez le greffon «&#x202f;%1&#x202f;», une partie de Palpate.</translation>
    </message>
    <message>
        <source>driver skipped</source>
        <translation>pilote ignoré</translation>
    </message>
    <message>
        <source>Install the maker&apos;s Touch driver and OpenHaptics 3, connect the arm, run Touch_Setup.</source>
        <translation>Installez le pilote Touch et OpenHaptics 3 du fabricant, branchez le bras, lancez Touch_Setup.</translation>
    </message>
    <message>
        <source>Install the maker&apos;s Force Dimension SDK 3, connect the arm, switch it on.</source>
        <translation>Installez le Force Dimension SDK 3 du fabricant, branchez le bras, allumez-le.</translation>
    </message>
    <message>
        <source>Start the maker&apos;s Inverse Service (3.1 or later), connect the arm, calibrate it in the Haply Hub.</source>
        <translation>Démarrez l’Inverse Service du fabricant (3.1 ou plus récent), branchez le bras, étalonnez-le dans le Haply Hub.</translation>
    </message>
    <message>
        <source>Connect the arm by USB, choose it in the menu Device, then Device › Calibrate.</source>
        <translation>Branchez le bras par USB, choisissez-le dans le menu Appareil, puis Appareil › Étalonner.</translation>
    </message>
    <message>
        <source>Connect it by USB. It has no motors: it moves the hand or the view, or sets the force.</source>
        <translation>Branchez-la par USB. Elle n’a pas de moteurs&#x202f;: elle déplace la main ou la vue, ou règle la force.</translation>
    </message>
    <message>
        <source>Start the program that sends the tracked tool, such as 3D Slicer, at port 18944. There is no force on the hand.</source>
        <translation>Démarrez le programme qui envoie l’outil suivi, comme 3D Slicer, au port 18944. Aucune force n’agit sur la main.</translation>
    </message>
    <message>
        <source>connected, not supported yet</source>
        <translation>branché, pas encore pris en charge</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>The drivers were tested against emulated hardware only. The mouse and the simulated hand need no device. The page “devices” of the documentation (Help menu) describes each installation.</source>
        <translation>Les pilotes n’ont été testés que contre du matériel émulé. La souris et la main simulée n’ont besoin d’aucun appareil. La page «&#x202f;devices&#x202f;» de la documentation (menu Aide) décrit chaque installation.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Chercher à nouveau</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DeviceChoice</name>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>%1 (skipped)</source>
        <translation>%1 (ignoré)</translation>
    </message>
    <message>
        <source>SpaceMouse moves the view</source>
        <translation>SpaceMouse déplace la vue</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>souris</translation>
    </message>
    <message>
        <source>simulated hand</source>
        <translation>main simulée</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 perdu</translation>
    </message>
    <message>
        <source>%1: calibrate</source>
        <translation>%1&#x202f;: étalonner</translation>
    </message>
    <message>
        <source>Up to %1 N and %2 N/mm</source>
        <translation>Jusqu’à %1&#xa0;N et %2&#xa0;N/mm</translation>
    </message>
    <message>
        <source>SpaceMouse presses</source>
        <translation>La SpaceMouse appuie</translation>
    </message>
    <message>
        <source>Mouse pointer over the view; the force is displayed, not felt</source>
        <translation>Pointeur de la souris sur la vue&#x202f;; la force est affichée, non sentie</translation>
    </message>
    <message>
        <source>Replay with current tissue</source>
        <translation>Rejouer avec le tissu actuel</translation>
    </message>
    <message>
        <source>Repeats the motion of the open recording on the current tissue</source>
        <translation>Répète le mouvement de l’enregistrement ouvert sur le tissu actuel</translation>
    </message>
    <message>
        <source>Use the current pose of the device as calibration pose</source>
        <translation>Utiliser la position actuelle de l’appareil comme position d’étalonnage</translation>
    </message>
    <message>
        <source>Connected devices…</source>
        <translation>Appareils branchés…</translation>
    </message>
    <message>
        <source>The puck rotates and moves the anatomy while another device palpates</source>
        <translation>Le palet tourne et déplace l’anatomie pendant qu’un autre appareil palpe</translation>
    </message>
    <message>
        <source>The pointer sets the place, the puck sets the force: the further down, the more newtons</source>
        <translation>Le pointeur fixe l’endroit, le palet la force&#x202f;: plus il est enfoncé, plus il y a de newtons</translation>
    </message>
    <message>
        <source>replayed recording</source>
        <translation>enregistrement rejoué</translation>
    </message>
    <message>
        <source>Input device: %1</source>
        <translation>Appareil d’entrée&#x202f;: %1</translation>
    </message>
    <message>
        <source>No force feedback: forces up to %1 N are displayed only.</source>
        <translation>Sans retour d’effort&#x202f;: les forces sont seulement affichées, jusqu’à %1 N.</translation>
    </message>
    <message>
        <source>Simulated hand (no device)</source>
        <translation>Main simulée (sans appareil)</translation>
    </message>
    <message>
        <source>Computed hand that palpates the centre of the view and responds to the force</source>
        <translation>Main calculée qui palpe le centre de la vue et réagit à la force</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DistancesPanel</name>
    <message>
        <source>0, they cross</source>
        <translation>0, ils se croisent</translation>
    </message>
    <message>
        <source>inside, %1 below</source>
        <translation>à l’intérieur, à %1 de profondeur</translation>
    </message>
    <message>
        <source>around, %1</source>
        <translation>autour, %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Measure from</source>
        <translation>Mesurer depuis</translation>
    </message>
    <message>
        <source>Borders of the bands in millimetres</source>
        <translation>Limites des bandes en millimètres</translation>
    </message>
    <message>
        <source>Borders of the bands of the margin [mm], at most four, such as 5; 10</source>
        <translation>Limites des bandes de la marge [mm], quatre au plus, par exemple 5&#x202f;; 10</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Bands [mm]</source>
        <translation>Bandes [mm]</translation>
    </message>
    <message>
        <source>Distances between structures</source>
        <translation>Distances entre structures</translation>
    </message>
    <message>
        <source>Tapes</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected tapes (Del)</source>
        <translation>Supprimer les mètres choisis (Suppr)</translation>
    </message>
    <message>
        <source>T: tape between two places</source>
        <translation>T&#x202f;: mètre entre deux points</translation>
    </message>
    <message>
        <source>Bands: found “%1”, expected at most four ascending distances in mm, such as 5; 10.</source>
        <translation>Bandes&#x202f;: trouvé «&#x202f;%1&#x202f;», attendu quatre distances croissantes en mm au plus, par exemple 5&#x202f;; 10.</translation>
    </message>
    <message>
        <source>lumps</source>
        <translation>nodules</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>No lump here: choose the structure to measure from.</source>
        <translation>Pas de nodule ici&#x202f;: choisissez la structure depuis laquelle mesurer.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>%1 of its area</source>
        <translation>%1 de sa surface</translation>
    </message>
    <message>
        <source>Select a row to see its closest points.</source>
        <translation>Sélectionnez une ligne pour voir ses points les plus proches.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EnergyBar</name>
    <message>
        <source>Energy observer</source>
        <translation>Bilan d’énergie</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1&#xa0;mJ</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EngineeringPanel</name>
    <message>
        <source>%1 µs</source>
        <translation>%1&#xa0;µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Click for the details (View › Engineering).</source>
        <translation>Cliquer pour les détails (Affichage › Technique).</translation>
    </message>
    <message>
        <source>computer too busy</source>
        <translation>ordinateur surchargé</translation>
    </message>
    <message>
        <source>force may stutter</source>
        <translation>la force peut saccader</translation>
    </message>
    <message>
        <source>running well</source>
        <translation>marche bien</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>Contraintes</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Measured rate</source>
        <translation>Cadence mesurée</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Gigue</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Pas en retard</translation>
    </message>
    <message>
        <source>Dropped ticks</source>
        <translation>Pas perdus</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Damping added</source>
        <translation>Amortissement ajouté</translation>
    </message>
    <message>
        <source>Device round trip</source>
        <translation>Aller-retour de l’appareil</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>Device reports</source>
        <translation>Rapports de l’appareil</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1&#xa0;kHz</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>Cadence de la boucle</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Cadence servo</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>CPU of the servo loop</source>
        <translation>CPU de la boucle</translation>
    </message>
    <message>
        <source>Servo CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>99.9 % below %1</source>
        <translation>99,9&#x202f;% sous %1</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1&#xa0;mJ</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
    <message>
        <source>median %1, 99 % below %2</source>
        <translation>médiane %1, 99 % sous %2</translation>
    </message>
    <message>
        <source>%1, %2 rejected, %3 dropouts</source>
        <translation>%1, %2 rejetés, %3 pertes</translation>
    </message>
    <message>
        <source>Touch runs at %1 updates per second instead of %2, so forces may stutter. Close other programs.</source>
        <translation>Le toucher est calculé %1 fois par seconde au lieu de %2&#x202f;; la force peut saccader. Fermez d’autres programmes.</translation>
    </message>
    <message>
        <source>Touch has no real-time priority, so other programs may make the force stutter. The list of messages (F4) explains how to allow real-time priority.</source>
        <translation>Le toucher n’a pas de priorité temps réel&#x202f;; d’autres programmes peuvent faire saccader la force. La liste des messages (F4) explique comment l’autoriser.</translation>
    </message>
    <message>
        <source>Touch runs at the full rate of %1 updates per second.</source>
        <translation>Le toucher tourne à pleine cadence, %1 fois par seconde.</translation>
    </message>
    <message>
        <source>Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ].
A negative value means that the simulation adds energy; damping then removes the surplus.</source>
        <translation>Bilan d’énergie&#x202f;: énergie que la main a fournie au tissu touché sans la récupérer [mJ].
Une valeur négative signifie que la simulation ajoute de l’énergie&#x202f;; l’amortissement retire alors l’excédent.</translation>
    </message>
    <message>
        <source>Real-time settings of the servo thread</source>
        <translation>Réglages temps réel du fil servo</translation>
    </message>
    <message>
        <source>Active constraints: surface planes that hold the hand back (at most 3)</source>
        <translation>Contraintes actives&#x202f;: plans de la surface qui retiennent la main (3 au plus)</translation>
    </message>
    <message>
        <source>Solver time per tick, for ticks with a hand</source>
        <translation>Durée d’un pas dans le solveur, pour les pas avec une main</translation>
    </message>
    <message>
        <source>Servo ticks per second, over the last half second [kHz]</source>
        <translation>Pas servo par seconde, sur la dernière demi-seconde [kHz]</translation>
    </message>
    <message>
        <source>Deviation of the tick interval from the period; 99.9 % of the ticks stay below this value</source>
        <translation>Écart de l’intervalle entre deux pas à la période&#x202f;; 99,9 % des pas restent sous cette valeur</translation>
    </message>
    <message>
        <source>Ticks that finished late, out of all ticks since the loop started, and the periods skipped as a result</source>
        <translation>Pas finis en retard, sur tous les pas depuis le début de la boucle, et périodes sautées de ce fait</translation>
    </message>
    <message>
        <source>Ticks missing from this recording because the disk was too slow</source>
        <translation>Pas absents de cet enregistrement car le disque était trop lent</translation>
    </message>
    <message>
        <source>Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ]</source>
        <translation>Bilan d’énergie&#x202f;: énergie que la main a fournie au tissu touché sans la récupérer [mJ]</translation>
    </message>
    <message>
        <source>Force that the passivity controller adds against the motion [N]</source>
        <translation>Force que le contrôleur de passivité ajoute contre le mouvement [N]</translation>
    </message>
    <message>
        <source>Time from receiving a device report to writing the resulting force</source>
        <translation>Temps entre la réception d’un rapport de l’appareil et l’écriture de la force résultante</translation>
    </message>
    <message>
        <source>Assumed delay until the force acts; limits the stable stiffness</source>
        <translation>Retard supposé avant que la force agisse&#x202f;; limite la raideur stable</translation>
    </message>
    <message>
        <source>Reports received, reports rejected as implausible, and connection losses</source>
        <translation>Rapports reçus, rapports rejetés comme non plausibles et pertes de connexion</translation>
    </message>
    <message>
        <source>Ticks per second. A faster loop keeps stiffer tissue stable if the device keeps up; check the jitter.</source>
        <translation>Pas par seconde. Une boucle plus rapide garde stable un tissu plus raide si l’appareil suit&#x202f;; surveiller la gigue.</translation>
    </message>
    <message>
        <source>CPU %1 only</source>
        <translation>CPU %1 seul</translation>
    </message>
    <message>
        <source>CPU for the servo loop. A single CPU helps only if no other program uses that CPU;
otherwise choose &quot;Any&quot;.</source>
        <translation>CPU de la boucle d’asservissement. Un seul CPU n’aide que si aucun autre programme ne l’utilise&#x202f;;
sinon choisir «&#x202f;Libre&#x202f;».</translation>
    </message>
    <message>
        <source>%1 of %2, %3 skipped</source>
        <translation>%1 sur %2, sautés&#x202f;: %3</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ExerciseBar</name>
    <message>
        <source>Time of the exercise</source>
        <translation>Temps de l’exercice</translation>
    </message>
    <message>
        <source>Force and force ceiling of the exercise</source>
        <translation>Force et plafond de force de l’exercice</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltOverlay</name>
    <message>
        <source>pressed %1 mm</source>
        <translation>en appuyant de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>touched lightly</source>
        <translation>touché légèrement</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>0 %: no lump</source>
        <translation>0&#x202f;%&#x202f;: aucun nodule</translation>
    </message>
    <message>
        <source>28 %: plainly felt</source>
        <translation>28&#x202f;%&#x202f;: nettement senti</translation>
    </message>
    <message>
        <source>Palpability, %1
(estimate)</source>
        <translation>Palpabilité, %1
(estimation)</translation>
    </message>
    <message>
        <source>7 %: not noticed</source>
        <translation>7 %&#x202f;: non remarqué</translation>
    </message>
    <message>
        <source>14 %: by a trained hand</source>
        <translation>14 %&#x202f;: par une main exercée</translation>
    </message>
    <message>
        <source>%1 %: maximum here</source>
        <translation>%1 %&#x202f;: maximum ici</translation>
    </message>
    <message>
        <source>Palpability</source>
        <translation>Palpabilité</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltPanel</name>
    <message>
        <source>Estimate for research and rehearsal.</source>
        <translation>Estimation pour la recherche et la répétition.</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>Pressed %1 mm</source>
        <translation>Appuyé de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Touched lightly</source>
        <translation>Touché légèrement</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Saisie</translation>
    </message>
    <message>
        <source>From the two Young&apos;s moduli</source>
        <translation>Des deux modules de Young</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the lump [kPa]</source>
        <translation>Module de Young du nodule [kPa]</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the organ [kPa]</source>
        <translation>Module de Young de l’organe [kPa]</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation>&#xa0;kPa</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>dans %1</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 et %2</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Raideur de %1</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Rapport de raideur</translation>
    </message>
    <message>
        <source>Tissue above</source>
        <translation>Tissu au-dessus</translation>
    </message>
    <message>
        <source>Lumps and their palpability</source>
        <translation>Nodules et leur palpabilité</translation>
    </message>
    <message>
        <source>Press depth of the finger</source>
        <translation>Profondeur d’appui du doigt</translation>
    </message>
    <message>
        <source>Colours: pressed %1 mm</source>
        <translation>Couleurs&#x202f;: appui de %1 mm</translation>
    </message>
    <message>
        <source>Colours: touched lightly</source>
        <translation>Couleurs&#x202f;: toucher léger</translation>
    </message>
    <message>
        <source>Show the best place</source>
        <translation>Montrer le meilleur endroit</translation>
    </message>
    <message>
        <source>Stiffness of the lump relative to the organ</source>
        <translation>Raideur du nodule par rapport à l’organe</translation>
    </message>
    <message>
        <source>Source of the stiffness ratio</source>
        <translation>Source du rapport de raideur</translation>
    </message>
    <message>
        <source>From tissues or names</source>
        <translation>D’après tissus ou noms</translation>
    </message>
    <message>
        <source>Published: %1, %2</source>
        <translation>Publié&#x202f;: %1, %2</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>exposed</source>
        <translation>à découvert</translation>
    </message>
    <message>
        <source>enter a ratio or choose a published one</source>
        <translation>saisir ou choisir une valeur publiée</translation>
    </message>
    <message>
        <source>Stiffness ratio to the organ:</source>
        <translation>Rapport de raideur à l’organe&#x202f;:</translation>
    </message>
    <message>
        <source>%1, stiffness ratio to %2:</source>
        <translation>%1, rapport de raideur à %2&#x202f;:</translation>
    </message>
    <message>
        <source>No place above this lump can be judged.</source>
        <translation>Aucun endroit au-dessus de ce nodule ne peut être jugé.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltWords</name>
    <message>
        <source>not by hand</source>
        <translation>pas à la main</translation>
    </message>
    <message>
        <source>by a trained hand</source>
        <translation>par une main exercée</translation>
    </message>
    <message>
        <source>plainly</source>
        <translation>nettement</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>saisie</translation>
    </message>
    <message>
        <source>from the moduli</source>
        <translation>des modules</translation>
    </message>
    <message>
        <source>from the tissues&apos; stiffness</source>
        <translation>de la raideur des tissus</translation>
    </message>
    <message>
        <source>plainly felt</source>
        <translation>nettement senti</translation>
    </message>
    <message>
        <source>not judged here: %1</source>
        <translation>non jugé ici&#x202f;: %1</translation>
    </message>
    <message>
        <source>;
%1 when pressed %2 mm</source>
        <translation>&#x202f;;
%1 en appuyant de %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: %2 mm below, %3 (%4 … %5 %): %6</source>
        <translation>%1&#x202f;: %2&#xa0;mm dessous, %3 (%4 … %5&#x202f;%)&#x202f;: %6</translation>
    </message>
    <message>
        <source>stiffness ratio not known</source>
        <translation>rapport de rigidité inconnu</translation>
    </message>
    <message>
        <source>published for such lumps</source>
        <translation>publié pour de telles masses</translation>
    </message>
    <message>
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (à %2&#x202f;: %3&#x202f;; à %4&#x202f;: %5)</translation>
    </message>
    <message>
        <source>surface too curved</source>
        <translation>surface trop courbée</translation>
    </message>
    <message>
        <source>organ too thin</source>
        <translation>organe trop mince</translation>
    </message>
    <message>
        <source>lumps overlap</source>
        <translation>nodules superposés</translation>
    </message>
    <message>
        <source>felt by a trained hand</source>
        <translation>senti par une main exercée</translation>
    </message>
    <message>
        <source>too little for a trained hand</source>
        <translation>trop peu pour une main exercée</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>no palpable lump here</source>
        <translation>aucun nodule palpable ici</translation>
    </message>
    <message>
        <source>%1 (stiffness ratio %2)</source>
        <translation>%1 (rapport de raideur %2)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsModel</name>
    <message>
        <source>%1: %2 N, %3 mm deep</source>
        <translation>%1&#x202f;: %2&#xa0;N, prof. %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Delete %1 findings</source>
        <translation>Supprimer %1 points</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>№</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Type of %1</source>
        <translation>Type de %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>Size of %1</source>
        <translation>Taille de %1</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Note sur %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>stiffness %1 N/mm</source>
        <translation>raideur %1 N/mm</translation>
    </message>
    <message>
        <source>Number in the view</source>
        <translation>Numéro dans la vue</translation>
    </message>
    <message>
        <source>Palpated structure and surrounding organ</source>
        <translation>Structure palpée et organe environnant</translation>
    </message>
    <message>
        <source>Estimated diameter [mm]</source>
        <translation>Diamètre estimé [mm]</translation>
    </message>
    <message>
        <source>Force of this structure at the time of marking [N]</source>
        <translation>Force de cette structure au marquage [N]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth in this structure at the time of marking [mm]</source>
        <translation>Profondeur dans cette structure au marquage [mm]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>Size: found “%1”, expected millimetres such as %2.</source>
        <translation>Taille&#x202f;: «&#x202f;%1&#x202f;» trouvé, millimètres attendus comme %2.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsPanel</name>
    <message>
        <source>Findings and notes</source>
        <translation>Points repérés et notes</translation>
    </message>
    <message>
        <source>New note without a place</source>
        <translation>Nouvelle note sans endroit</translation>
    </message>
    <message>
        <source>Write a note (N), Enter saves</source>
        <translation>Écrire une note (N), Entrée enregistre</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Play from here</source>
        <translation>Lire à partir d’ici</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Enter the size</source>
        <translation>Saisir la taille</translation>
    </message>
    <message>
        <source>Write a note</source>
        <translation>Écrire une note</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>No findings yet. Press on a place, then click Mark or press M.</source>
        <translation>Aucun point repéré. Appuyer à un endroit, puis cliquer sur Marquer ou taper M.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FingerInset</name>
    <message>
        <source>Section along the finger</source>
        <translation>Coupe le long du doigt</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>Along the finger: touch a structure</source>
        <translation>Le long du doigt&#x202f;: toucher une structure</translation>
    </message>
    <message>
        <source>Along the finger</source>
        <translation>Le long du doigt</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceBar</name>
    <message>
        <source>%1 N of %2 N</source>
        <translation>%1&#xa0;N sur %2&#xa0;N</translation>
    </message>
    <message>
        <source>Force of the model [N]; the bar ends at the device&apos;s limit of %1 N</source>
        <translation>Force du modèle [N]&#x202f;; la barre s’arrête à la limite de l’appareil, %1&#xa0;N</translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation>limite %1&#xa0;N</translation>
    </message>
    <message>
        <source>Force in newtons</source>
        <translation>Force en newtons</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceTimeline</name>
    <message>
        <source>no recording</source>
        <translation>aucun enregistrement</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 sur %2&#xa0;s</translation>
    </message>
    <message>
        <source>%1, %2 N</source>
        <translation>%1, %2&#xa0;N</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1&#xa0;s&#x202f;: %2</translation>
    </message>
    <message>
        <source>The force of a recording appears here</source>
        <translation>La force d’un enregistrement apparaît ici</translation>
    </message>
    <message>
        <source> s</source>
        <translation>&#xa0;s</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
    <message>
        <source>Force timeline of the recording</source>
        <translation>Chronologie de la force de l’enregistrement</translation>
    </message>
    <message>
        <source>Force [N] during the recording. Click or drag to seek; ← and → step by 0.1 s, Home and End jump to the ends.</source>
        <translation>Force [N] pendant l’enregistrement. Cliquer ou glisser pour s’y placer&#x202f;; ← et → avancent de 0,1 s, Début et Fin vont aux extrémités.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandControl</name>
    <message>
        <source>The whole scene</source>
        <translation>Toute la scène</translation>
    </message>
    <message>
        <source>%1; using any CPU</source>
        <translation>%1&#x202f;; CPU libre</translation>
    </message>
    <message>
        <source>First touch a place, point at one or mark a finding (M).</source>
        <translation>D’abord toucher un endroit, le pointer ou marquer un point (M).</translation>
    </message>
    <message>
        <source>No visible structure to fit the workspace to.</source>
        <translation>Aucune structure visible à laquelle ajuster l’espace de travail.</translation>
    </message>
    <message>
        <source>%1 fills the workspace. The hand stays in contact; Centre moves the hand to the middle.</source>
        <translation>L’espace de travail est rempli par&#x202f;: %1. La main reste en contact&#x202f;; Centrer la ramène au milieu.</translation>
    </message>
    <message>
        <source>%1 fills the workspace.</source>
        <translation>L’espace de travail est rempli par&#x202f;: %1.</translation>
    </message>
    <message>
        <source>10 mm around the contact</source>
        <translation>10 mm autour du contact</translation>
    </message>
    <message>
        <source>10 mm around the pointer</source>
        <translation>10 mm autour du pointeur</translation>
    </message>
    <message>
        <source>10 mm around finding %1</source>
        <translation>10 mm autour du point %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandPanel</name>
    <message>
        <source>1 mm of the device is %1 mm of the scene.</source>
        <translation>1&#xa0;mm de l’appareil vaut %1&#xa0;mm de la scène.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Encore rien</translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation>Force sur la main</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source> mm per mm</source>
        <translation>&#xa0;mm par mm</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Lever la main</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centrer</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Bouton %1</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Depth (wheel)</source>
        <translation>Profondeur (molette)</translation>
    </message>
    <message>
        <source> N</source>
        <translation>&#xa0;N</translation>
    </message>
    <message>
        <source>Force on the hand %1 N of %2 N</source>
        <translation>Force sur la main %1&#xa0;N sur %2&#xa0;N</translation>
    </message>
    <message>
        <source>No motors: forces are displayed, not felt. Any stiffness is possible.</source>
        <translation>Pas de moteurs&#x202f;: les forces sont affichées, non senties. Toute raideur est possible.</translation>
    </message>
    <message>
        <source>This device can render tissue up to %1 N/mm.</source>
        <translation>Cet appareil peut rendre un tissu jusqu’à %1 N/mm.</translation>
    </message>
    <message>
        <source>Edge of the workspace: move the device back to the middle. Until then, the hand in the scene does not move.</source>
        <translation>Bord de l’espace de travail&#x202f;: ramenez l’appareil au milieu. D’ici là, la main ne bouge pas dans la scène.</translation>
    </message>
    <message>
        <source>Lifted: the device moves, the hand in the scene does not.</source>
        <translation>Levée&#x202f;: l’appareil bouge, la main dans la scène non.</translation>
    </message>
    <message>
        <source>The hand is inside %1, which is only felt from outside. Move the hand out towards you first.</source>
        <translation>La main est dans %1, palpable seulement de l’extérieur. Ramenez d’abord la main vers vous.</translation>
    </message>
    <message>
        <source>Unscaled: 1 mm of the device is 1 mm of the scene.</source>
        <translation>Sans échelle&#x202f;: 1 mm de l’appareil vaut 1 mm de la scène.</translation>
    </message>
    <message>
        <source>%1 fills the workspace: 1 mm of the device is %2 mm of the scene.</source>
        <translation>L’espace de travail est rempli par&#x202f;: %1. 1 mm de l’appareil vaut %2 mm de la scène.</translation>
    </message>
    <message>
        <source>Maximum tissue stiffness</source>
        <translation>Raideur maximale du tissu</translation>
    </message>
    <message>
        <source>Map the full device range to all visible structures (W)</source>
        <translation>Étendre toute la course de l’appareil à toutes les structures visibles (W)</translation>
    </message>
    <message>
        <source>Map the full device range to the touched organ, or else to the organ under the pointer or the selected one (O)</source>
        <translation>Étendre toute la course de l’appareil à l’organe touché, sinon à celui sous le pointeur ou à l’organe choisi (O)</translation>
    </message>
    <message>
        <source>Map the full device range to 10 mm around the contact, or else around the pointer or the newest finding (L)</source>
        <translation>Étendre toute la course de l’appareil à 10 mm autour du contact, sinon autour du pointeur ou du dernier point repéré (L)</translation>
    </message>
    <message>
        <source>Fit workspace to</source>
        <translation>Ajuster l’espace de travail à</translation>
    </message>
    <message>
        <source>Current workspace</source>
        <translation>Espace de travail actuel</translation>
    </message>
    <message>
        <source>Scene millimetres per device millimetre</source>
        <translation>Millimètres de la scène par millimètre de l’appareil</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Scene axes</source>
        <translation>Axes de la scène</translation>
    </message>
    <message>
        <source>Device orientation</source>
        <translation>Orientation de l’appareil</translation>
    </message>
    <message>
        <source>View: right is right on screen, however the view is rotated.
Patient: right is the patient&apos;s left, up is towards the head.
Scene axes: device coordinates equal scene coordinates, without scaling; the hand cannot be lifted.</source>
        <translation>Vue&#x202f;: la droite est à droite à l’écran, quelle que soit l’orientation de la vue.
Patient&#x202f;: la droite est la gauche du patient, le haut va vers la tête.
Axes de la scène&#x202f;: les coordonnées de l’appareil sont celles de la scène, sans échelle&#x202f;; la main ne peut être levée.</translation>
    </message>
    <message>
        <source>Aligned with</source>
        <translation>Aligné sur</translation>
    </message>
    <message>
        <source>Function of button %1</source>
        <translation>Fonction du bouton %1</translation>
    </message>
    <message>
        <source>Swaps the first two buttons</source>
        <translation>Échange les deux premiers boutons</translation>
    </message>
    <message>
        <source>While held, the device moves and the hand in the scene does not; C switches lifting on and off</source>
        <translation>Tant qu’il est tenu, l’appareil bouge et la main dans la scène non&#x202f;; C active ou désactive</translation>
    </message>
    <message>
        <source>Centres the device range on the fitted region</source>
        <translation>Centre la course de l’appareil sur la région ajustée</translation>
    </message>
    <message>
        <source>Force (hold)</source>
        <translation>Force (tenir)</translation>
    </message>
    <message>
        <source>Press mode</source>
        <translation>Mode d’appui</translation>
    </message>
    <message>
        <source>Depth: the same depth everywhere; a stiff place pushes back harder.
Force: the same force everywhere; a stiff place yields less. The force rises by 1 N per second while the button is held; with a pen, the pen pressure sets the force. (E)</source>
        <translation>Profondeur&#x202f;: la même partout&#x202f;; un endroit raide repousse plus fort.
Force&#x202f;: la même partout&#x202f;; un endroit raide cède moins. La force croît de 1 N par seconde tant que le bouton est tenu&#x202f;; avec un stylet, sa pression fixe la force. (E)</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>Force limit of a press and force at full pen pressure; the wheel changes the value by 0.5 N</source>
        <translation>Limite de force d’un appui et force à pleine pression du stylet&#x202f;; la molette change la valeur de 0,5 N</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Computed hand, no device: it presses what is in the middle of the view. Force and stiffness have the limits of the chosen device.</source>
        <translation>Main calculée, sans appareil&#x202f;: elle presse ce qui est au milieu de la vue. Force et raideur ont les limites de l’appareil choisi.</translation>
    </message>
    <message>
        <source>Limits of</source>
        <translation>Limites de</translation>
    </message>
    <message>
        <source>Shows how tissue feels at a device that is not here: force, stiffness and damping are bounded as by this device</source>
        <translation>Montre ce que l’on sentirait avec un appareil absent&#x202f;: force, raideur et amortissement sont limités comme avec cet appareil</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Main simulée</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HintLine</name>
    <message>
        <source>Latest message; F4 shows all</source>
        <translation>Dernier message&#x202f;; F4 les affiche tous</translation>
    </message>
    <message>
        <source>%1
Click here or press F4 for all messages</source>
        <translation>%1
Cliquer ici ou taper F4 pour tous les messages</translation>
    </message>
    <message>
        <source>No new messages</source>
        <translation>Aucun nouveau message</translation>
    </message>
</context>
<context>
    <name>palpate::ui::KeysCard</name>
    <message>
        <source>All keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>in the list: %1</source>
        <translation>dans la liste&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawEditor</name>
    <message>
        <source>Load points…</source>
        <translation>Charger des points…</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Stiffer with depth</source>
        <translation>Plus raide en profondeur</translation>
    </message>
    <message>
        <source>Ball on soft tissue</source>
        <translation>Boule sur tissu mou</translation>
    </message>
    <message>
        <source>Thin layer</source>
        <translation>Couche mince</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Déclic</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Points mesurés</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tableaux (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Loi de force</translation>
    </message>
    <message>
        <source>How the force rises with depth</source>
        <translation>Comment la force croît avec la profondeur</translation>
    </message>
    <message>
        <source>Load a measured curve from a CSV file with columns depth_mm and force_N</source>
        <translation>Charger une courbe mesurée depuis un fichier CSV avec les colonnes depth_mm et force_N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawPlot</name>
    <message>
        <source>%1 mm deep</source>
        <translation>prof. %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>– – device %1 N/mm</source>
        <translation>– – appareil %1&#xa0;N/mm</translation>
    </message>
    <message>
        <source>now %1 mm</source>
        <translation>ici %1&#xa0;mm</translation>
    </message>
    <message>
        <source>now %1 mm, here × %2</source>
        <translation>maintenant %1&#xa0;mm, ici × %2</translation>
    </message>
    <message>
        <source>Force in newtons over depth in millimetres</source>
        <translation>Force en newtons selon la profondeur en millimètres</translation>
    </message>
    <message>
        <source>Force [N] over depth [mm]. Drag a point, or select one with ← → and move with ↑ ↓</source>
        <translation>Force [N] selon la profondeur [mm]. Glisser un point, ou en choisir un par ← → et le déplacer par ↑ ↓</translation>
    </message>
    <message>
        <source>Force [N] over depth [mm]</source>
        <translation>Force [N] selon la profondeur [mm]</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LegendGrip</name>
    <message>
        <source>Close the legend; the View menu shows it again</source>
        <translation>Fermer la légende&#x202f;; le menu Affichage l’affiche de nouveau</translation>
    </message>
    <message>
        <source>Drag the legend to another corner</source>
        <translation>Glisser la légende dans un autre coin</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LiveTouch</name>
    <message>
        <source>%1 can render tissue up to %2 N/mm.</source>
        <translation>%1 peut rendre un tissu jusqu’à %2 N/mm.</translation>
    </message>
    <message>
        <source>%1 can render tissue up to %2 N/mm here.</source>
        <translation>%1 peut rendre ici un tissu jusqu’à %2 N/mm.</translation>
    </message>
    <message>
        <source> This is the rating of the manufacturer.</source>
        <translation> C’est la valeur annoncée par le fabricant.</translation>
    </message>
    <message>
        <source> The force is delayed by %1 ms; stiffer tissue could make the device vibrate.</source>
        <translation> La force est retardée de %1 ms&#x202f;; un tissu plus raide pourrait faire vibrer l’appareil.</translation>
    </message>
    <message>
        <source> 1 mm of the device is %1 mm of the scene; a smaller scale (Device panel) allows stiffer tissue.</source>
        <translation> 1 mm de l’appareil vaut %1 mm de la scène&#x202f;; une échelle plus petite (panneau Appareil) permet un tissu plus raide.</translation>
    </message>
    <message>
        <source>%1 is set to %2 N/mm but feels like %3 N/mm, the maximum that %4 can render here%5.</source>
        <translation>%1 est réglé à %2 N/mm mais se sent comme %3 N/mm, le maximum que %4 peut rendre ici%5.</translation>
    </message>
    <message>
        <source> in addition to the surrounding layers</source>
        <translation> en plus des couches environnantes</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Looks</name>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark text on light panels</source>
        <translation>Texte sombre sur panneaux clairs</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light text on dark panels, for a dark room</source>
        <translation>Texte clair sur panneaux sombres, pour une pièce sombre</translation>
    </message>
    <message>
        <source>High contrast, on black</source>
        <translation>Contraste élevé, sur noir</translation>
    </message>
    <message>
        <source>High contrast, on white</source>
        <translation>Contraste élevé, sur blanc</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light or dark, following the system</source>
        <translation>Clair ou sombre, selon le système</translation>
    </message>
    <message>
        <source>White text on black, with visible edges</source>
        <translation>Texte blanc sur noir, avec des bords visibles</translation>
    </message>
    <message>
        <source>Black text on white, with visible edges</source>
        <translation>Texte noir sur blanc, avec des bords visibles</translation>
    </message>
    <message>
        <source>Text size of the system</source>
        <translation>Taille de texte du système</translation>
    </message>
    <message>
        <source>Text size in panels and in the view</source>
        <translation>Taille du texte dans les panneaux et dans la vue</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LumpMaps</name>
    <message>
        <source>No lump was found inside a closed organ.</source>
        <translation>Aucun nodule trouvé dans un organe fermé.</translation>
    </message>
    <message>
        <source>Computing how lumps in %1 feel; simulated as layers until then</source>
        <translation>Calcul des nodules dans %1&#x202f;; simulés comme couches d’ici là</translation>
    </message>
    <message>
        <source>Palpability of %1</source>
        <translation>Palpabilité de %1</translation>
    </message>
    <message>
        <source>The stiffness ratio of %2 to %1 is unknown, so palpability is not judged. Enter a ratio under What can be felt (B) or choose a published one.</source>
        <translation>Le rapport de raideur de %2 à %1 est inconnu, la palpabilité n’est donc pas jugée. Saisir une valeur sous «&#x202f;Ce qui se sent&#x202f;» (B) ou en choisir une publiée.</translation>
    </message>
    <message>
        <source>The computation of buried lumps was cancelled. Lumps are simulated as layers until the scene changes.</source>
        <translation>Le calcul des nodules enfouis a été annulé. Les nodules sont simulés comme couches jusqu’au prochain changement de la scène.</translation>
    </message>
    <message>
        <source>The computation of palpability was cancelled.</source>
        <translation>Le calcul de la palpabilité a été annulé.</translation>
    </message>
    <message>
        <source>%1 lumps were left out.</source>
        <translation>%1 nodules ont été omis.</translation>
    </message>
    <message>
        <source>%1 was left out: %2.</source>
        <translation>%1 a été omis&#x202f;: %2.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapDisplay</name>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>module d’Young, kPa</translation>
    </message>
    <message>
        <source>shear modulus, kPa</source>
        <translation>module de cisaillement, kPa</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>damping, N·s/mm</source>
        <translation>amortissement, N·s/mm</translation>
    </message>
    <message>
        <source>friction, relative to the tissue</source>
        <translation>frottement, relatif au tissu</translation>
    </message>
    <message>
        <source>felt stiffness, N/mm</source>
        <translation>raideur sentie, N/mm</translation>
    </message>
    <message>
        <source>felt stiffness, relative to the law</source>
        <translation>raideur sentie, relative à la loi</translation>
    </message>
    <message>
        <source>%1: no data</source>
        <translation>%1&#x202f;: pas de données</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>pas de données</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapEditor</name>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Par nom</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Shear modulus, kPa</source>
        <translation>Module de cisaillement, kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>Module d’Young, kPa</translation>
    </message>
    <message>
        <source>Contact radius in mm</source>
        <translation>Rayon de contact en mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation>&#xa0;mm</translation>
    </message>
    <message>
        <source>Contact radius</source>
        <translation>Rayon de contact</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;All files (*)</source>
        <translation>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Volume…</source>
        <translation>Volume…</translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation>Couleur propre</translation>
    </message>
    <message>
        <source>%1 varies by %2.</source>
        <translation>%1 varie selon %2.</translation>
    </message>
    <message>
        <source>Variation of the tissue over the surface</source>
        <translation>Variation du tissu sur la surface</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuelle</translation>
    </message>
    <message>
        <source>Mesh arrays with a known name, such as StiffnessScale</source>
        <translation>Tableaux du maillage au nom connu, comme StiffnessScale</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Propriété</translation>
    </message>
    <message>
        <source>Tissue property that varies</source>
        <translation>Propriété du tissu qui varie</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Mesh array or volume with the values</source>
        <translation>Tableau du maillage ou volume contenant les valeurs</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Meaning of the numbers. Shear modulus and Young&apos;s modulus differ by a factor of three; check the scanner manual</source>
        <translation>Signification des nombres. Module de cisaillement et module d’Young diffèrent d’un facteur trois&#x202f;; voir le manuel de l’imageur</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>choisir…</translation>
    </message>
    <message>
        <source>Relative to the tissue</source>
        <translation>Relatif au tissu</translation>
    </message>
    <message>
        <source>Stiffness, N/mm</source>
        <translation>Raideur, N/mm</translation>
    </message>
    <message>
        <source>Radius of the finger contact; stiffness = 8 × radius × shear modulus</source>
        <translation>Rayon du contact du doigt&#x202f;; raideur = 8 × rayon × module de cisaillement</translation>
    </message>
    <message>
        <source>Limit the values</source>
        <translation>Borner les valeurs</translation>
    </message>
    <message>
        <source>Values outside the range are set to the nearest limit</source>
        <translation>Les valeurs hors bornes sont ramenées à la borne la plus proche</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Map status</source>
        <translation>État de la carte</translation>
    </message>
    <message>
        <source>Colours the structure by value, with a legend</source>
        <translation>Colore la structure selon les valeurs, avec une légende</translation>
    </message>
    <message>
        <source>Choose the unit of %1: shear modulus and Young&apos;s modulus differ by a factor of three.</source>
        <translation>Choisissez l’unité de %1&#x202f;: module de cisaillement et module d’Young diffèrent d’un facteur trois.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 places have no value. The tissue value is used there.</source>
        <translation>%1&#x202f;: %2 endroits sur %3 n’ont pas de valeur. La valeur du tissu y est utilisée.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapWarnings</name>
    <message>
        <source>(%1; %2; %3) mm</source>
        <translation>(%1&#x202f;; %2&#x202f;; %3) mm</translation>
    </message>
    <message>
        <source>%1: the effect of the lumps below changes too abruptly for the %2 at %3.</source>
        <translation>%1&#x202f;: l’effet des nodules dessous change trop brusquement pour «&#x202f;%2&#x202f;» en %3.</translation>
    </message>
    <message>
        <source>%1: the stiffness map changes too abruptly for the %2 at %3.</source>
        <translation>%1&#x202f;: la carte de raideur change trop brusquement pour «&#x202f;%2&#x202f;» en %3.</translation>
    </message>
    <message>
        <source>The sideways force jumps by %1 N there and can make the hand oscillate by %2 mm.</source>
        <translation>La force latérale y saute de %1 N et peut faire osciller la main de %2 mm.</translation>
    </message>
    <message>
        <source>Add friction to the tissue, or use a mesh with shorter edges there.</source>
        <translation>Ajouter du frottement au tissu, ou utiliser un maillage aux arêtes plus courtes à cet endroit.</translation>
    </message>
    <message>
        <source>Spread the step over a longer distance, smooth both ends, or add friction to the tissue.</source>
        <translation>Étaler la marche sur une plus grande distance, arrondir ses bouts, ou ajouter du frottement au tissu.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MarginOverlay</name>
    <message>
        <source>%1
to %2,
share of its area</source>
        <translation>%1
à %2,
part de sa surface</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageBar</name>
    <message>
        <source> … and %1 more lines (F4)</source>
        <translation> … et %1 lignes de plus (F4)</translation>
    </message>
    <message>
        <source>Show the list of messages (F4)</source>
        <translation>Afficher la liste des messages (F4)</translation>
    </message>
    <message>
        <source>1 older message (F4 shows all)</source>
        <translation>1 message antérieur (F4 affiche tout)</translation>
    </message>
    <message>
        <source>%1 older messages (F4 shows all)</source>
        <translation>%1 messages antérieurs (F4 affiche tout)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Copier (Ctrl+C)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageRow</name>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
    <message>
        <source>Close this message; still listed under Messages (F4)</source>
        <translation>Fermer ce message&#x202f;; il reste dans la liste des messages (F4)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Messages</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Alerte</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Offer</source>
        <translation>Proposition</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MotionPanel</name>
    <message>
        <source>Let the tissue move, or stop it where it is</source>
        <translation>Laisser bouger le tissu, ou l’arrêter où il est</translation>
    </message>
    <message>
        <source>Hold breath</source>
        <translation>Retenir le souffle</translation>
    </message>
    <message>
        <source>Hold breathing tissue where it is; pulses and tracked poses go on</source>
        <translation>Arrêter le tissu qui respire où il est&#x202f;; les pouls et les poses suivies continuent</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Rate of the motion</source>
        <translation>Vitesse du mouvement</translation>
    </message>
    <message>
        <source>Speed of all motions; 1 is that of the scene file</source>
        <translation>Vitesse de tous les mouvements&#x202f;; 1 est celle du fichier de scène</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>Amplitude of the breath</source>
        <translation>Amplitude de la respiration</translation>
    </message>
    <message>
        <source>Share of the displacement of the scene file; at 0 % breathing tissue rests</source>
        <translation>Part du déplacement du fichier de scène&#x202f;; à 0 %, le tissu qui respire est au repos</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>palpate::ui::PalpationController</name>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
    <message>
        <source>presses up to %1 N</source>
        <translation>appuie jusqu’à %1&#xa0;N</translation>
    </message>
    <message>
        <source>pressing %1 mm, slid aside</source>
        <translation>appui %1&#xa0;mm, glissé sur le côté</translation>
    </message>
    <message>
        <source>presses %1 mm</source>
        <translation>appuie de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>pressing %1 mm</source>
        <translation>appui %1&#xa0;mm</translation>
    </message>
    <message>
        <source>pressing %1 of %2 mm</source>
        <translation>appui %1 sur %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 mm is the maximum depth, limited by the size of the scene.</source>
        <translation>%1 mm est la profondeur maximale, limitée par la taille de la scène.</translation>
    </message>
    <message>
        <source>%1 N is the maximum press force.</source>
        <translation>%1 N est la force d’appui maximale.</translation>
    </message>
    <message>
        <source>No palpable structure is in view.</source>
        <translation>Aucune structure palpable dans la vue.</translation>
    </message>
    <message>
        <source>target %1 of %2 N, actual %3 N, %4 mm</source>
        <translation>cible %1 sur %2 N, réel %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Playback</name>
    <message>
        <source>structure %1</source>
        <translation>structure %1</translation>
    </message>
    <message>
        <source>A: %1, B: %2</source>
        <translation>A&#x202f;: %1, B&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::PointedStructure</name>
    <message>
        <source>image: %1</source>
        <translation>image&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message>
        <source>%1 ends at %2 s because the disk was full. Later palpation was not recorded.</source>
        <translation>%1 s’arrête à %2 s car le disque était plein. La palpation ultérieure n’a pas été enregistrée.</translation>
    </message>
    <message>
        <source>%1 ends at %2 s because of a disk write error. Later palpation was not recorded.</source>
        <translation>%1 s’arrête à %2 s à cause d’une erreur d’écriture sur le disque. La palpation ultérieure n’a pas été enregistrée.</translation>
    </message>
    <message>
        <source>%1 was not closed (crash or full disk) and ends at %2 s. Later palpation was not recorded.</source>
        <translation>%1 n’a pas été fermé (plantage ou disque plein) et s’arrête à %2 s. La palpation ultérieure n’a pas été enregistrée.</translation>
    </message>
    <message>
        <source>%1: %2 samples were lost during recording because the disk was too slow.</source>
        <translation>%1&#x202f;: %2 échantillons ont été perdus à l’enregistrement car le disque était trop lent.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged or was changed after recording: %n part(s) do not match their checksums and are left out. &quot;palpate session verify&quot; names the first part.</source>
        <translation>
            <numerusform>%1 est endommagé ou a été modifié après l’enregistrement&#x202f;: %n partie ne correspond pas à sa somme de contrôle et est omise. «&#x202f;palpate session verify&#x202f;» nomme la première partie.</numerusform>
            <numerusform>%1 est endommagé ou a été modifié après l’enregistrement&#x202f;: %n parties ne correspondent pas à leurs sommes de contrôle et sont omises. «&#x202f;palpate session verify&#x202f;» nomme la première partie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneDistances</name>
    <message>
        <source>Measuring distances</source>
        <translation>Mesure des distances</translation>
    </message>
    <message>
        <source>Measuring distances was cancelled.</source>
        <translation>La mesure des distances a été annulée.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneLoader</name>
    <message>
        <source>Nothing to open.</source>
        <translation>Rien à ouvrir.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation>Préparation du toucher</translation>
    </message>
    <message>
        <source>view</source>
        <translation>vue</translation>
    </message>
    <message>
        <source>unknown fields</source>
        <translation>champs inconnus</translation>
    </message>
    <message>
        <source>%1: opened together with another scene; not imported: %2</source>
        <translation>%1&#x202f;: ouvert avec une autre scène&#x202f;; non repris&#x202f;: %2</translation>
    </message>
    <message>
        <source>Finding structures inside others</source>
        <translation>Recherche des structures contenues dans d’autres</translation>
    </message>
    <message>
        <source>Drawing the scene</source>
        <translation>Dessin de la scène</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SectionBar</name>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Direction of the section</source>
        <translation>Direction de la coupe</translation>
    </message>
    <message>
        <source>Direction of the section; Free faces the viewer when chosen</source>
        <translation>Direction de la coupe&#x202f;; «&#x202f;Libre&#x202f;» fait face à l’observateur au moment du choix</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>Position de la coupe</translation>
    </message>
    <message>
        <source>Position from the origin of the coordinates towards left, back or head. Shift and the wheel over the view move the section</source>
        <translation>Position depuis l’origine des coordonnées vers la gauche, l’arrière ou la tête. Maj et la molette sur la vue déplacent la coupe</translation>
    </message>
    <message>
        <source>Show the other side of the section</source>
        <translation>Montrer l’autre côté de la coupe</translation>
    </message>
    <message>
        <source>End the section</source>
        <translation>Terminer la coupe</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Range of numbers from black to white</source>
        <translation>Plage des valeurs du noir au blanc</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Number shown in medium grey</source>
        <translation>Valeur affichée en gris moyen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SessionPanel</name>
    <message>
        <source>Position and length</source>
        <translation>Position et durée</translation>
    </message>
    <message>
        <source>Position / length [min:s]</source>
        <translation>Position / durée [min:s]</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1&#xa0;×</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>No recording yet. Record one with R, or open a .palpate file.</source>
        <translation>Aucun enregistrement. En faire un avec R, ou ouvrir un fichier .palpate.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 late, %2 lost</source>
        <translation>%1 en retard, %2 perdus</translation>
    </message>
    <message>
        <source>Playback speed; 1 × is real time</source>
        <translation>Vitesse de lecture&#x202f;; 1 × est le temps réel</translation>
    </message>
    <message>
        <source>Force timeline of the second recording</source>
        <translation>Courbe de force du second enregistrement</translation>
    </message>
    <message>
        <source>A %1, B %2</source>
        <translation>A %1, B %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureList</name>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrer par nom</translation>
    </message>
    <message>
        <source>Filter the structures by name</source>
        <translation>Filtrer les structures par nom</translation>
    </message>
    <message>
        <source>Order and groups of the list</source>
        <translation>Ordre et groupes de la liste</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Comme ouvert</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Par nom</translation>
    </message>
    <message>
        <source>By tissue, softest first</source>
        <translation>Par tissu, le plus mou d’abord</translation>
    </message>
    <message>
        <source>By layer, outermost first</source>
        <translation>Par couche, de dehors en dedans</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>By file or folder</source>
        <translation>Par fichier ou dossier</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>List only structures with these words in the name (Ctrl+F); Esc lists all</source>
        <translation>Ne lister que les structures dont le nom contient ces mots (Ctrl+F)&#x202f;; Échap liste tout</translation>
    </message>
    <message>
        <source>By layer</source>
        <translation>Par couche</translation>
    </message>
    <message>
        <source>By anatomy</source>
        <translation>Par anatomie</translation>
    </message>
    <message>
        <source>Targets of the exercise can be felt, but are neither drawn nor named until the exercise ends</source>
        <translation>Les cibles de l’exercice peuvent être palpées, mais ne sont ni dessinées ni nommées avant la fin de l’exercice</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n cible cachée</numerusform>
            <numerusform>%n cibles cachées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureModel</name>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Remove %1 structures</source>
        <translation>Retirer %1 structures</translation>
    </message>
    <message>
        <source>outermost</source>
        <translation>en premier</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>sous %1</translation>
    </message>
    <message>
        <source>The mesh is open: feels like a sheet</source>
        <translation>Le maillage est ouvert&#x202f;: senti comme une feuille</translation>
    </message>
    <message>
        <source>Part of the mesh is open: feels like a sheet there</source>
        <translation>Une partie du maillage est ouverte&#x202f;: sentie là comme une feuille</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation>Nom et couleur</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>through %1</source>
        <translation>à travers %1</translation>
    </message>
    <message>
        <source>Turn %1 around</source>
        <translation>Retourner %1</translation>
    </message>
    <message>
        <source>Turn %1 surfaces around</source>
        <translation>Retourner %1 surfaces</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Lisser %1</translation>
    </message>
    <message>
        <source>Smooth %1 surfaces</source>
        <translation>Lisser %1 surfaces</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm</source>
        <translation>La surface est lissée&#x202f;: déplacée de %1 mm au plus</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm, volume %2 %</source>
        <translation>La surface est lissée&#x202f;: déplacée de %1 mm au plus, volume %2 %</translation>
    </message>
    <message>
        <source>%1 below surface</source>
        <translation>%1 sous la surface</translation>
    </message>
    <message>
        <source>The surface has steps of %1 × %2 × %3 mm voxels, which can be felt</source>
        <translation>La surface a des marches de voxels de %1 × %2 × %3 mm, sensibles au toucher</translation>
    </message>
    <message>
        <source>The mesh is inside out: palpable only from inside</source>
        <translation>Le maillage est retourné&#x202f;: palpable seulement de l’intérieur</translation>
    </message>
    <message>
        <source>Mesh defects were repaired</source>
        <translation>Des défauts du maillage ont été corrigés</translation>
    </message>
    <message>
        <source>Some edges are shared by more than two triangles</source>
        <translation>Certaines arêtes appartiennent à plus de deux triangles</translation>
    </message>
    <message>
        <source>%1 is visible. Click to hide; hidden structures cannot be felt.</source>
        <translation>%1 est visible. Cliquer pour masquer&#x202f;; les structures masquées ne sont pas palpables.</translation>
    </message>
    <message>
        <source>%1 is hidden. Click to show.</source>
        <translation>%1 est invisible. Cliquer pour afficher.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
%2 triangles
Depth order: %3</source>
        <translation>%1
%2 triangles
Ordre en profondeur&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1 is palpable. Click to let the hand pass through.</source>
        <translation>%1 est palpable. Cliquer pour que la main passe à travers.</translation>
    </message>
    <message>
        <source>The hand passes through %1. Click to make palpable.</source>
        <translation>La main passe à travers %1. Cliquer pour rendre palpable.</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Notes on the mesh</source>
        <translation>Remarques sur le maillage</translation>
    </message>
    <message>
        <source>Palpable</source>
        <translation>Palpable</translation>
    </message>
    <message>
        <source>The surface is not smoothed: it is too small</source>
        <translation>La surface n’est pas lissée&#x202f;: elle est trop petite</translation>
    </message>
    <message>
        <source>Close the holes of %1</source>
        <translation>Fermer les trous de %1</translation>
    </message>
    <message>
        <source>Close the holes of %1 surfaces</source>
        <translation>Fermer les trous de %1 surfaces</translation>
    </message>
    <message>
        <source>Reopen the holes of %1</source>
        <translation>Rouvrir les trous de %1</translation>
    </message>
    <message>
        <source>Reopen the holes of %1 surfaces</source>
        <translation>Rouvrir les trous de %1 surfaces</translation>
    </message>
    <message>
        <source>A hole of %1 mm was closed</source>
        <translation>Un trou de %1 mm a été fermé</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 mm were closed</source>
        <translation>%1 trous jusqu’à %2 mm ont été fermés</translation>
    </message>
    <message>
        <source>Mesh of %1:
• %2
Details: %3</source>
        <translation>Maillage de %1&#x202f;:
• %2
Détails&#x202f;: %3</translation>
    </message>
    <message>
        <source>unnamed structure</source>
        <translation>structure sans nom</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructurePanel</name>
    <message>
        <source>Colour of the structure</source>
        <translation>Couleur de la structure</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Opacity in per cent</source>
        <translation>Opacité en pour cent</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Change %1 structures</source>
        <translation>Modifier %1 structures</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1 structures</source>
        <translation>%1 structures</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>No structure selected</source>
        <translation>Aucune structure choisie</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Source&#x202f;: %1</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Couleur de %1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Retirer de la scène</translation>
    </message>
    <message>
        <source>Very soft organ</source>
        <translation>Organe très mou</translation>
    </message>
    <message>
        <source>Soft organ</source>
        <translation>Organe mou</translation>
    </message>
    <message>
        <source>Firm organ</source>
        <translation>Organe ferme</translation>
    </message>
    <message>
        <source>Firm lump</source>
        <translation>Nodule ferme</translation>
    </message>
    <message>
        <source>Hard lump</source>
        <translation>Nodule dur</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Liver, healthy (2.3 kPa)</source>
        <translation>Foie, sain (2,3&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, fibrotic (5.9 kPa)</source>
        <translation>Foie, fibreux (5,9&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, malignant (10.1 kPa)</source>
        <translation>Foie, malin (10,1&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, stiffer with depth</source>
        <translation>Foie, plus raide en profondeur</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>as a layer, %1</source>
        <translation>comme couche, %1</translation>
    </message>
    <message>
        <source>%1 (felt from above)</source>
        <translation>%1 (senti d’en haut)</translation>
    </message>
    <message>
        <source>through %1 (felt from above)</source>
        <translation>à travers %1 (senti d’en haut)</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Comme dans le fichier</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissée</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Turn around</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Kidney (5.0 kPa)</source>
        <translation>Rein (5,0 kPa)</translation>
    </message>
    <message>
        <source>Spleen (2.9 kPa)</source>
        <translation>Rate (2,9 kPa)</translation>
    </message>
    <message>
        <source>Pancreas (4.8 kPa)</source>
        <translation>Pancréas (4,8 kPa)</translation>
    </message>
    <message>
        <source>Thyroid (11.0 kPa)</source>
        <translation>Thyroïde (11,0 kPa)</translation>
    </message>
    <message>
        <source>Salivary gland (10.9 kPa)</source>
        <translation>Glande salivaire (10,9 kPa)</translation>
    </message>
    <message>
        <source>Muscle at rest (11.1 kPa)</source>
        <translation>Muscle au repos (11,1 kPa)</translation>
    </message>
    <message>
        <source>Tendon (51.5 kPa)</source>
        <translation>Tendon (51,5 kPa)</translation>
    </message>
    <message>
        <source>Prostate (17.0 kPa)</source>
        <translation>Prostate (17,0 kPa)</translation>
    </message>
    <message>
        <source>Breast (3.2 kPa)</source>
        <translation>Sein (3,2 kPa)</translation>
    </message>
    <message>
        <source>Lymph node</source>
        <translation>Ganglion</translation>
    </message>
    <message>
        <source>Opacity [%]; at lower values, structures behind show through</source>
        <translation>Opacité [%]&#x202f;; aux valeurs basses, les structures derrière transparaissent</translation>
    </message>
    <message>
        <source>%1 [%2]: %3</source>
        <translation>%1 [%2]&#x202f;: %3</translation>
    </message>
    <message>
        <source>Tissue preset</source>
        <translation>Tissu prédéfini</translation>
    </message>
    <message>
        <source>Stability warning for the map</source>
        <translation>Alerte de stabilité de la carte</translation>
    </message>
    <message>
        <source>Friction preset</source>
        <translation>Frottement prédéfini</translation>
    </message>
    <message>
        <source>Effective stiffness</source>
        <translation>Raideur effective</translation>
    </message>
    <message>
        <source>Reason for rejecting the value</source>
        <translation>Motif du refus de la valeur</translation>
    </message>
    <message>
        <source>Depth order, from outside</source>
        <translation>Ordre en profondeur, de dehors en dedans</translation>
    </message>
    <message>
        <source>Order in which a pressing hand meets the structures (Ctrl+Down, Ctrl+Up in the list)</source>
        <translation>Ordre dans lequel la main qui appuie rencontre les structures (Ctrl+Bas, Ctrl+Haut dans la liste)</translation>
    </message>
    <message>
        <source>Depth order</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>own surface, outermost</source>
        <translation>propre surface, en premier</translation>
    </message>
    <message>
        <source>%1 uses %2</source>
        <translation>%1 utilise %2</translation>
    </message>
    <message>
        <source>limited to at most %1 N/mm: the device can render %2 N/mm in total%3</source>
        <translation>limité à %1 N/mm au plus&#x202f;: l’appareil peut rendre %2 N/mm au total%3</translation>
    </message>
    <message>
        <source>limited to %1 N/mm: the device can render %2 N/mm in total%3</source>
        <translation>limité à %1 N/mm&#x202f;: l’appareil peut rendre %2 N/mm au total%3</translation>
    </message>
    <message>
        <source>Invalid force law: %1.</source>
        <translation>Loi de force non valide&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 N·s/mm is too much: the device can render at most %2 N·s/mm. Enter %2 N·s/mm or less.</source>
        <translation>%1 N·s/mm est trop&#x202f;: l’appareil peut rendre au plus %2 N·s/mm. Saisissez %2 N·s/mm ou moins.</translation>
    </message>
    <message>
        <source>%1 Of this, %2.</source>
        <translation>%1 De cela, %2.</translation>
    </message>
    <message>
        <source>%1 N/mm is too stiff. %2 Enter %3 N/mm or less.</source>
        <translation>%1 N/mm est trop raide. %2 Saisissez %3 N/mm ou moins.</translation>
    </message>
    <message>
        <source>The force law is too steep: up to %1 N/mm. %2 Enter values with a slope of at most %3 N/mm.</source>
        <translation>La loi de force est trop raide&#x202f;: jusqu’à %1 N/mm. %2 Saisissez des valeurs dont la pente est d’au plus %3 N/mm.</translation>
    </message>
    <message>
        <source>Show only the selection</source>
        <translation>N’afficher que la sélection</translation>
    </message>
    <message>
        <source>Make only the selection palpable</source>
        <translation>Ne rendre palpable que la sélection</translation>
    </message>
    <message>
        <source>Make all palpable</source>
        <translation>Tout rendre palpable</translation>
    </message>
    <message>
        <source>none, assumed values</source>
        <translation>aucune, valeurs supposées</translation>
    </message>
    <message>
        <source>shear modulus from MR elastography (PMC2894569), for a fingertip of 5 mm radius</source>
        <translation>module de cisaillement par élastographie IRM (PMC2894569), pour un bout de doigt de 5 mm de rayon</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from shear-wave ultrasound (Arda et al. 2011, AJR 197:532), for a fingertip of 5 mm radius</source>
        <translation>module d’Young par ultrasons à ondes de cisaillement (Arda et al. 2011, AJR 197:532), pour un bout de doigt de 5 mm de rayon</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from indentation (Urology 2010), for a fingertip of 5 mm radius</source>
        <translation>module d’Young par indentation (Urology 2010), pour un bout de doigt de 5 mm de rayon</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from indentation (Teixeira et al. 2023), for a fingertip of 5 mm radius</source>
        <translation>module d’Young par indentation (Teixeira et al. 2023), pour un bout de doigt de 5 mm de rayon</translation>
    </message>
    <message>
        <source>assumed value below 22 kPa, the malignancy threshold of lymph nodes (2.71 m/s by shear-wave ultrasound)</source>
        <translation>valeur supposée sous 22 kPa, seuil de malignité des ganglions (2,71 m/s par ultrasons à ondes de cisaillement)</translation>
    </message>
    <message>
        <source>shape after Carter et al. 2001 (exponential), assumed values</source>
        <translation>forme d’après Carter et al. 2001 (exponentielle), valeurs supposées</translation>
    </message>
    <message>
        <source>Demo: ball on soft ground</source>
        <translation>Démo&#x202f;: boule sur fond mou</translation>
    </message>
    <message>
        <source>shape after Hertz 1882, assumed values</source>
        <translation>forme d’après Hertz 1882, valeurs supposées</translation>
    </message>
    <message>
        <source>Demo: clicking button</source>
        <translation>Démo&#x202f;: bouton à déclic</translation>
    </message>
    <message>
        <source>Wet (0.05, assumed)</source>
        <translation>Mouillé (0,05, supposé)</translation>
    </message>
    <message>
        <source>Moist (0.15, assumed)</source>
        <translation>Humide (0,15, supposé)</translation>
    </message>
    <message>
        <source>Dry (0.40, assumed)</source>
        <translation>Sec (0,40, supposé)</translation>
    </message>
    <message>
        <source>Curved facets</source>
        <translation>Facettes courbes</translation>
    </message>
    <message>
        <source>Smoothed, curved facets</source>
        <translation>Lissée, facettes courbes</translation>
    </message>
    <message>
        <source>Smoothing removes voxel steps for display and touch, moving the surface by at most half a voxel. Curved facets make coarse facets round; edges of more than 40° stay sharp. The file is not changed.</source>
        <translation>Le lissage supprime les marches de voxels pour l’affichage et le toucher et déplace la surface d’un demi-voxel au plus. Les facettes courbes arrondissent les facettes grossières&#x202f;; les arêtes de plus de 40° restent vives. Le fichier n’est pas modifié.</translation>
    </message>
    <message>
        <source>%1 triangles, %2 MiB for touch</source>
        <translation>%1 triangles, %2 Mio pour le toucher</translation>
    </message>
    <message>
        <source>Smoothing factor</source>
        <translation>Facteur de lissage</translation>
    </message>
    <message>
        <source>Smoothing factor, from 0 (nearly none) to 1. A larger factor removes steps of thick slices, and changes the shape more</source>
        <translation>Facteur de lissage, de 0 (presque aucun) à 1. Un facteur plus grand efface les marches des coupes épaisses et modifie davantage la forme</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Close the holes</source>
        <translation>Fermer les trous</translation>
    </message>
    <message>
        <source>Close the hole of %1 mm</source>
        <translation>Fermer le trou de %1 mm</translation>
    </message>
    <message>
        <source>Close %1 holes of up to %2 mm</source>
        <translation>Fermer %1 trous jusqu’à %2 mm</translation>
    </message>
    <message>
        <source>Reopen the holes</source>
        <translation>Rouvrir les trous</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>Maps are off until the exercise ends</source>
        <translation>Les cartes sont désactivées jusqu’à la fin de l’exercice</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureTree</name>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Hide all of %1</source>
        <translation>Tout masquer&#x202f;: %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Tout afficher&#x202f;: %1</translation>
    </message>
    <message>
        <source>Let the hand pass through all of %1</source>
        <translation>Laisser passer la main à travers tout&#x202f;: %1</translation>
    </message>
    <message>
        <source>Outermost</source>
        <translation>En premier</translation>
    </message>
    <message>
        <source>%1 below surface</source>
        <translation>%1 sous la surface</translation>
    </message>
    <message>
        <source>Make all of %1 palpable</source>
        <translation>Tout rendre palpable&#x202f;: %1</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>Masses</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organes</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Vaisseaux</translation>
    </message>
    <message>
        <source>Brain and nerves</source>
        <translation>Cerveau et nerfs</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Cartilage and tendons</source>
        <translation>Cartilages et tendons</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Muscles</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Peau et graisse</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TapeTool</name>
    <message>
        <source>Tape: click on two places, or touch a place and press T, then another. Esc ends.</source>
        <translation>Mètre&#x202f;: cliquez sur deux points, ou touchez un point et appuyez sur T, puis un autre. Échap termine.</translation>
    </message>
    <message>
        <source>The tape is put away.</source>
        <translation>Le mètre est rangé.</translation>
    </message>
    <message>
        <source>Tape: click on a structure.</source>
        <translation>Mètre&#x202f;: cliquez sur une structure.</translation>
    </message>
    <message>
        <source>Tape: first end set.</source>
        <translation>Mètre&#x202f;: première extrémité placée.</translation>
    </message>
    <message>
        <source>Tape: first end on %1.</source>
        <translation>Mètre&#x202f;: première extrémité sur %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TapesModel</name>
    <message>
        <source>Tape %1</source>
        <translation>Mètre %1</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mesurer %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Delete %1 tapes</source>
        <translation>Supprimer %1 mètres</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Mètre</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchChart</name>
    <message>
        <source>Chart of force and depth over the last ten seconds</source>
        <translation>Courbe de force et profondeur sur les dix dernières secondes</translation>
    </message>
    <message>
        <source>Force [N] and depth [mm] over the last 10 s</source>
        <translation>Force [N] et profondeur [mm] sur les 10 dernières&#xa0;s</translation>
    </message>
    <message>
        <source>−10 s</source>
        <translation>−10&#xa0;s</translation>
    </message>
    <message>
        <source>−5 s</source>
        <translation>−5&#xa0;s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>le long de la surface</translation>
    </message>
    <message>
        <source>no contact yet</source>
        <translation>pas encore de contact</translation>
    </message>
    <message>
        <source>now %1 N, %2 mm deep; maximum %3 N, %4 mm</source>
        <translation>à présent %1 N, prof. %2 mm&#x202f;; maximum %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchMap</name>
    <message>
        <source>Examined surface</source>
        <translation>Surface examinée</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Temps passé</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>Stiffness felt</source>
        <translation>Raideur ressentie</translation>
    </message>
    <message>
        <source>No map</source>
        <translation>Aucune carte</translation>
    </message>
    <message>
        <source>Time spent, s</source>
        <translation>Temps passé, s</translation>
    </message>
    <message>
        <source>Largest force, N</source>
        <translation>Force maximale, N</translation>
    </message>
    <message>
        <source>Stiffness felt, N/mm</source>
        <translation>Raideur ressentie, N/mm</translation>
    </message>
    <message>
        <source>live, %1 s (preview)</source>
        <translation>en direct, %1 s (aperçu)</translation>
    </message>
    <message>
        <source>up to %1 s</source>
        <translation>jusqu’à %1 s</translation>
    </message>
    <message>
        <source>nothing touched yet</source>
        <translation>rien de touché pour l’instant</translation>
    </message>
    <message>
        <source>touched: %1</source>
        <translation>touché&#x202f;: %1</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>au-dessus de %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>touché</translation>
    </message>
    <message>
        <source>A up to %1 s, B up to %2 s</source>
        <translation>A jusqu’à %1 s, B jusqu’à %2 s</translation>
    </message>
    <message>
        <source>only A: %1</source>
        <translation>A seul&#x202f;: %1</translation>
    </message>
    <message>
        <source>both: %1</source>
        <translation>les deux&#x202f;: %1</translation>
    </message>
    <message>
        <source>only B: %1</source>
        <translation>B seul&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>only A</source>
        <translation>A seul</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>only B</source>
        <translation>B seul</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchPanel</name>
    <message>
        <source>%1 N, %2 mm deep</source>
        <translation>%1&#xa0;N, prof. %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 mm deep · slid aside</source>
        <translation>prof. %1&#xa0;mm · glissé sur le côté</translation>
    </message>
    <message>
        <source>%1 mm deep · %2 N/mm</source>
        <translation>prof. %1&#xa0;mm · %2&#xa0;N/mm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force on the hand [N]</source>
        <translation>Force sur la main [N]</translation>
    </message>
    <message>
        <source>Touched structure</source>
        <translation>Structure touchée</translation>
    </message>
    <message>
        <source>Depth and stiffness</source>
        <translation>Profondeur et raideur</translation>
    </message>
    <message>
        <source>Not touching</source>
        <translation>Aucun contact</translation>
    </message>
    <message>
        <source>slid aside</source>
        <translation>glissé sur le côté</translation>
    </message>
    <message>
        <source>the hand is free</source>
        <translation>la main est libre</translation>
    </message>
    <message>
        <source>press on a structure to feel it</source>
        <translation>appuyer sur une structure pour la sentir</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>over %1: %2, %3</source>
        <translation>sur %1&#x202f;: %2, %3</translation>
    </message>
    <message>
        <source>over %1: %2</source>
        <translation>sur %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Force in newtons</source>
        <translation>Force en newtons</translation>
    </message>
    <message>
        <source>Touched structures from outside in, with forces and depths</source>
        <translation>Structures touchées de dehors en dedans, avec forces et profondeurs</translation>
    </message>
    <message>
        <source>Touched layers from outside in: share of the total force [N], measured along
the total force, and depth of the hand in each layer [mm]</source>
        <translation>Couches touchées de dehors en dedans&#x202f;: part de la force totale [N], mesurée le long
de celle-ci, et profondeur de la main dans chaque couche [mm]</translation>
    </message>
    <message>
        <source>Depth of the hand below the outermost surface [mm]; stiffness of all touched layers together [N/mm]</source>
        <translation>Profondeur de la main sous la surface la plus externe [mm]&#x202f;; raideur de toutes les couches touchées ensemble [N/mm]</translation>
    </message>
    <message>
        <source>The mesh has more triangles here than can be evaluated in time</source>
        <translation>Le maillage a ici plus de triangles qu’il n’est possible d’en évaluer à temps</translation>
    </message>
    <message>
        <source>very fine mesh here: force delayed</source>
        <translation>maillage très fin ici&#x202f;: force retardée</translation>
    </message>
    <message>
        <source>Source of the values: the live hand or the recording</source>
        <translation>Origine des valeurs&#x202f;: la main en direct ou l’enregistrement</translation>
    </message>
    <message>
        <source>Recording, %1 s</source>
        <translation>Enregistrement, %1 s</translation>
    </message>
    <message>
        <source>Live hand</source>
        <translation>Main en direct</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchSound</name>
    <message>
        <source>built without Qt Multimedia</source>
        <translation>compilé sans Qt Multimedia</translation>
    </message>
    <message>
        <source>no loudspeaker found</source>
        <translation>aucun haut-parleur trouvé</translation>
    </message>
    <message>
        <source>%1 cannot play the tone</source>
        <translation>%1 ne peut pas jouer le son</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>End (Esc)</source>
        <translation>Finir (Échap)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewKeys</name>
    <message>
        <source>← → ↑ ↓</source>
        <translation>← → ↑ ↓</translation>
    </message>
    <message>
        <source>+  −</source>
        <translation>+  −</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomer</translation>
    </message>
    <message>
        <source>Ctrl+← → ↑ ↓</source>
        <translation>Ctrl+← → ↑ ↓</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Page down  up</source>
        <translation>Page bas  haut</translation>
    </message>
    <message>
        <source>rotate the camera by 15°; with Shift: pan</source>
        <translation>tourner la caméra de 15°&#x202f;; avec Maj&#x202f;: la déplacer</translation>
    </message>
    <message>
        <source>move the press point by 2 mm on screen</source>
        <translation>déplacer le point d’appui de 2 mm à l’écran</translation>
    </message>
    <message>
        <source>press, release</source>
        <translation>appuyer, relâcher</translation>
    </message>
    <message>
        <source>press 0.5 mm deeper, less deep</source>
        <translation>appuyer 0,5 mm plus, moins profond</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewVoice</name>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>3D view: %1, %2</source>
        <translation>Vue 3D&#x202f;: %1, %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::WelcomePage</name>
    <message>
        <source>Try the phantom</source>
        <translation>Essayer le fantôme</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Feel segmented anatomy</source>
        <translation>Palper l’anatomie segmentée</translation>
    </message>
    <message>
        <source>Drop surface meshes or a scene here: %1</source>
        <translation>Déposer ici maillages de surface ou scène&#x202f;: %1</translation>
    </message>
    <message>
        <source>Open anatomy…</source>
        <translation>Ouvrir une anatomie…</translation>
    </message>
    <message>
        <source>Open mesh or scene files (Ctrl+O)</source>
        <translation>Ouvrir maillages ou scène (Ctrl+O)</translation>
    </message>
    <message>
        <source>or</source>
        <translation>ou</translation>
    </message>
    <message>
        <source>Open the bundled phantom: a liver with two lumps and a recorded palpation</source>
        <translation>Ouvrir le fantôme fourni&#x202f;: un foie avec deux nodules et une palpation enregistrée</translation>
    </message>
    <message>
        <source>Then click Palpate and drag on the anatomy to press; the wheel sets the depth. Press ? for all keys.</source>
        <translation>Cliquer ensuite sur Palper et glisser sur l’anatomie pour appuyer&#x202f;; la molette règle la profondeur.&#x202f;? affiche les raccourcis.</translation>
    </message>
</context>
</TS>
