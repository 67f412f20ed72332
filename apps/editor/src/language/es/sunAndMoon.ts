/** Spanish texts of sun, moon and sky by date and place. */
export const sunAndMoon = {
  'Sun And Moon': 'Sol y luna',
  'Sun and moon': 'Sol y luna',
  'Sun, moon and sky of a date, an hour and a place.': 'Sol, luna y cielo de una fecha, una hora y un lugar.',
  Hour: 'Hora',
  'Hour of the day by the clock of the time zone.': 'Hora del día según el reloj del huso horario.',
  Day: 'Día',
  'Day of the month.': 'Día del mes.',
  Month: 'Mes',
  'Month of the year.': 'Mes del año.',
  Year: 'Año',
  'Year of the Gregorian calendar.': 'Año del calendario gregoriano.',
  Place: 'Lugar',
  Latitude: 'Latitud',
  'Above 0 north of the equator.': 'Por encima de 0, al norte del ecuador.',
  Longitude: 'Longitud',
  'Above 0 east of Greenwich.': 'Por encima de 0, al este de Greenwich.',
  'Time zone': 'Huso horario',
  'Hours that clocks are ahead of universal time, summer time included.':
    'Horas que los relojes van por delante del tiempo universal, con el horario de verano.',
  North: 'Norte',
  'Turns the compass: at 0 north is towards -Z.': 'Gira la brújula: con 0 el norte está hacia -Z.',
  'As suits a screen without exposure, or in lux as measured, for a camera with exposure.':
    'Como conviene a una pantalla sin exposición, o en lux como se mide, para una cámara con exposición.',
  'For a screen': 'Para una pantalla',
  'As measured': 'Como se mide',
  'Show the sky': 'Mostrar el cielo',
  'Show the sky of the hour, which lights the scene too.':
    'Mostrar el cielo de la hora, que también ilumina la escena.',
  'Hours that pass in a second while the scene plays.':
    'Horas que pasan en un segundo mientras la escena se reproduce.',
  'Sun and moon give this light its colour, intensity and direction.':
    'El sol y la luna dan a esta luz su color, su intensidad y su dirección.',
  'Set place of {name}': 'Fijar lugar de {name}',
  'Map of the world: click to set the place, arrow keys move it':
    'Mapa del mundo: un clic fija el lugar, las flechas lo mueven',
  'Sun {elevation} high, at {azimuth}': 'Sol a {elevation} de altura, azimut {azimuth}',
  'Moon {elevation} high, {lit} % lit': 'Luna a {elevation} de altura, iluminada al {lit} %',
};
