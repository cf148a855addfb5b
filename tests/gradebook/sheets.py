"""Files as teachers download them, each with what makes trouble."""

ENGLISH = (
    'Identifier,"Full name","Email address",Status,Grade,"Maximum Grade",'
    '"Grade can be changed","Last modified (submission)","Last modified (grade)",'
    '"Feedback comments"\r\n'
    'Participant 106,"Our Fault",fault@uni.example,"Submitted for grading",,50.00,Yes,'
    '"Tuesday, 7 January 2025, 9:00 AM",-,"an older remark"\r\n'
    'Participant 101,"Ada Lovelace",ada@uni.example,"Submitted for grading",,50.00,Yes,'
    '"Tuesday, 7 January 2025, 9:00 AM",-,\r\n'
    'Participant 102,"Grace ""Amazing"" Hopper",grace@uni.example,"Submitted\nlate",,50.00,'
    'Yes,"Tuesday, 7 January 2025, 9:00 AM","Monday, 6 January 2025, 8:00 AM",""\r\n'
    'Participant 999,"Ada Lovelace",other.ada@uni.example,"No submission",,50.00,Yes,-,-,\r\n'
    'Participant 103,"Jörg Müller",jm@uni.example,"Submitted for grading","",50.00,Yes,-,-,\r\n'
    'Participant 104,"Lin Tan",lin@uni.example,"Submitted for grading",,50.00,No,-,-,\r\n'
    'Participant 105,"No File",no@uni.example,"Submitted for grading",,50.00,Yes,-,-,'
)

GERMAN = (
    'ID;"Vollständiger Name";E-Mail-Adresse;Status;Bewertung;Bestwertung;'
    '"Bewertung kann geändert werden";"Zuletzt geändert (Abgabe)";'
    '"Zuletzt geändert (Bewertung)";"Feedback als Kommentar"\n'
    'Teilnehmer/in102;"Grace Hopper";grace@uni.example;Abgegeben;;50,00;Ja;-;-;\n'
    'Teilnehmer/in101;"Ada Lovelace";ada@uni.example;Abgegeben;;50,00;Ja;-;-;\n'
)

FRENCH = (
    'Identifiant,"Nom complet","Adresse de courriel",Statut,Note,"Note maximale",'
    '"La note peut être modifiée","Dernière modification (note)","Feedback par commentaires"\n'
    '"Participant 102","Grace Hopper",grace@uni.example,-,,"50,00",Oui,-,\n'
    '"Participant 101","Ada Lovelace",ada@uni.example,-,,"50,00",Non,-,\n'
)

SPANISH = (
    'Identificador,"Nombre completo","Dirección de correo",Estado,Calificación,'
    '"Calificación máxima","La calificación puede ser cambiada",'
    '"Última modificación (calificación)","Comentarios de retroalimentación"\n'
    '"Participante 102","Grace Hopper",grace@uni.example,-,,"50,00",Sí,-,\n'
    '"Participante 101","Ada Lovelace",ada@uni.example,-,,"50,00",No,-,\n'
)

ITALIAN = (
    'Identificativo,Nome,"Indirizzo email",Stato,Valutazione,'
    '"Valutazione massima","La valutazione può essere cambiata",'
    '"Ultima modifica (valutazione)",Commenti\n'
    '"Partecipante 102","Grace Hopper",grace@uni.example,-,,"50,00",Sì,-,\n'
    '"Partecipante 101","Ada Lovelace",ada@uni.example,-,,"50,00",No,-,\n'
)

DUTCH = (
    'Identificatie,"Volledige naam",E-mailadres,Status,Cijfer,"Maximumcijfer",'
    '"Cijfer kan gewijzigd worden","Laatst gewijzigd (beoordeling)","Feedback opmerkingen"\n'
    '"Deelnemer 102","Grace Hopper",grace@uni.example,-,,"50,00",Ja,-,\n'
)
"""In a language whose words are not known here."""

GRADEBOOK = (
    'First name,Surname,ID number,Email address,"Assignment: Exercise 3 BVH (Real)",'
    '"Assignment: Exercise 3 BVH (Feedback)","Course total (Real)",'
    '"Last downloaded from this course"\n'
    "Ada,Lovelace,u1,ada@uni.example,-,,12.50,1736200000\n"
    "Grace,Höpper,u2,Grace@uni.example,-,,-,1736200000\n"
    "Nobody,Here,u3,nobody@uni.example,-,,-,1736200000\n"
)

CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Exercise 2 (55),Exercise 3 BVH (66),"
    "Current Score\n"
    "    Points Possible,,,,,10,50,(read only)\n"
    '"Lovelace, Ada",9001,u1,ada,CG-1,9.5,,95\n'
    '"Hopper, Grace",9002,u2,grace,CG-1,,12,80\n'
    '"=Müller, Jörg",9003,u3,jm,"CG-1 and ""CG-2""",,EX,\n'
    '"Student, Test",9009,,test,CG-1,,,\n'
)
