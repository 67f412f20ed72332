/** Spanish texts of light units, lamps and colour temperatures, and of the exposure of cameras. */
export const photometry = {
  'Whether the colour is chosen by hand, or is that of a temperature.':
    'Si el color se elige a mano o es el de una temperatura.',
  'Colour by': 'Color según',
  Hand: 'A mano',
  'Colour temperature: 1,850 K is a candle, 2,700 K a bulb, 6,500 K daylight. Lumens stay whatever it is.':
    'Temperatura de color: 1850 K es una vela, 2700 K una bombilla, 6500 K la luz del día. Los lúmenes no cambian.',
  'Unit that the intensity is shown and typed in; the light is the same. Lux of point and spot lights is at 1 m.':
    'Unidad en que se muestra y se escribe la intensidad; la luz es la misma. El lux de las luces puntuales y focales es a 1 m.',
  Unit: 'Unidad',
  'Kind of lamp whose watts stand for the light.': 'Tipo de lámpara cuyos vatios equivalen a la luz.',
  Lamp: 'Lámpara',
  LED: 'LED',
  Incandescent: 'Incandescente',
  Halogen: 'Halógena',
  Fluorescent: 'Fluorescente',
  'Candela (cd)': 'Candela (cd)',
  'Lumen (lm)': 'Lumen (lm)',
  'Lux (lx)': 'Lux (lx)',
  'Lux at 1 m (lx)': 'Lux a 1 m (lx)',
  'Nits (cd/m²)': 'Nits (cd/m²)',
  'Watt (W)': 'Vatio (W)',
  'Show intensity of {name} in {unit}': 'Mostrar intensidad de {name} en {unit}',
  'Made {name} a light like {preset}': '{name} es ahora una luz como {preset}',
  '40 W bulb': 'Bombilla de 40 W',
  '60 W bulb': 'Bombilla de 60 W',
  '100 W bulb': 'Bombilla de 100 W',
  'LED lamp, 8 W': 'Lámpara LED, 8 W',
  'Halogen spot, 50 W': 'Foco halógeno, 50 W',
  'Fluorescent tube, 32 W': 'Tubo fluorescente, 32 W',
  'LED panel of an office': 'Panel LED de oficina',
  'Sodium street lamp': 'Farola de sodio',
  'Metal halide floodlight, 400 W': 'Proyector de halogenuros, 400 W',
  'Headlamp of a car': 'Faro de coche',
  'Sun at noon': 'Sol de mediodía',
  'Overcast sky': 'Cielo cubierto',
  'Full moon': 'Luna llena',
  'By a factor, an exposure value, aperture, time and ISO as a camera has them, or by how bright the picture is.':
    'Por un número, por un valor de exposición, por apertura, tiempo e ISO como en una cámara, o según lo clara que sea la imagen.',
  'Exposure by': 'Exposición según',
  Factor: 'Factor',
  'Exposure value': 'Valor de exposición',
  'Aperture, time, ISO': 'Apertura, tiempo, ISO',
  'Exposure value at ISO 100: 15 for sunlight, 6 for a lit room, 0 where 1 cd/m² is nearly white.':
    'Valor de exposición a ISO 100: 15 para el sol, 6 para una sala iluminada, 0 donde 1 cd/m² es casi blanco.',
  Aperture: 'Apertura',
  'f-number: the smaller, the brighter.': 'Número f: cuanto menor, más clara.',
  'Shutter time': 'Tiempo de obturación',
  'How long the shutter is open: twice the time is twice the light.':
    'Cuánto está abierto el obturador: el doble de tiempo es el doble de luz.',
  ISO: 'ISO',
  'Speed of the sensor: twice the number is twice the light.': 'Sensibilidad del sensor: el doble es el doble de luz.',
  Lowest: 'Mínimo',
  'Exposure value below which a dark picture is made no brighter.':
    'Valor de exposición por debajo del cual una imagen oscura no se aclara más.',
  Highest: 'Máximo',
  'Exposure value above which a bright picture is made no darker.':
    'Valor de exposición por encima del cual una imagen clara no se oscurece más.',
  'Adaptation time': 'Tiempo de adaptación',
  'Time in which most of a change of light is made up for while the scene plays; 0 for at once.':
    'Tiempo en que se compensa casi todo un cambio de luz mientras la escena se reproduce; 0 de inmediato.',
  'Light meter': 'Fotómetro',
  Illuminance: 'Iluminancia',
  Exposure: 'Exposición',
  'Click a surface: the light that falls on it is measured, with all shadows.':
    'Haga clic en una superficie: se mide la luz que recibe, con todas las sombras.',
  'Light cannot be measured: this device cannot draw to float colour buffers.':
    'No se puede medir la luz: este dispositivo no dibuja en búferes de color flotantes.',
  'False colours of illuminance': 'Colores falsos de iluminancia',
  'Lux on surfaces': 'Lux en las superficies',
  'Scale: from 0.1 lux, blue, to 100,000 lux, red': 'Escala: de 0.1 lux, azul, a 100 000 lux, rojo',
};
