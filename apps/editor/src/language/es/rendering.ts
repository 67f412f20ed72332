import type { Texts } from '@farol/editing';

/** Spanish texts of techniques, debug views and the Frame panel. */
export const rendering: Texts = {
  Compare: 'Comparar',
  'Two techniques, side by side.': 'Dos técnicas, una junto a otra.',
  'Side by side': 'Una junto a otra',
  'Compare two techniques': 'Comparar dos técnicas',
  'The technique in use at the left of the picture, another one at its right.':
    'La técnica en uso a la izquierda de la imagen y otra a la derecha.',
  With: 'Con',
  'Technique to compare with': 'Técnica con la que comparar',
  Difference: 'Diferencia',
  'Show the difference': 'Mostrar la diferencia',
  'The difference of the two, channel by channel as it is seen, made larger.':
    'La diferencia entre ambas, canal a canal como se ve, aumentada.',
  'Made larger by': 'Aumentada por',
  'Difference made larger by': 'Diferencia aumentada por',
  'Difference of the two': 'Diferencia entre ambas',
  measuring: 'midiendo',
  'the same': 'iguales',
  Largest: 'Máxima',
  '{difference} of 255': '{difference} de 255',
  'Off by more than 2': 'Difieren en más de 2',
  '{percent}% of the pixels': '{percent} % de los píxeles',
  Automatic: 'Automático',
  'Ambient occlusion': 'Oclusión ambiental',
  'Indirect light reaches less into corners; "Automatic" then takes a technique with a G-buffer.':
    'La luz indirecta llega menos a los rincones; «Automático» elige entonces una técnica con G-buffer.',
  'Unsorted transparency': 'Transparencia sin ordenar',
  'Transparent layers are averaged, not sorted: they may pass through one another.':
    'Las capas transparentes se promedian, sin ordenarlas: pueden atravesarse.',
  'Volumetric fog': 'Niebla volumétrica',
  'Fog that all lights light, with their shadows: halos, beams and shafts.':
    'Niebla que iluminan todas las luces, con sus sombras: halos, haces y rayos.',
  Effects: 'Efectos',
  'What takes part in the picture beside the technique.': 'Lo que interviene en la imagen además de la técnica.',
  'Anti-aliasing': 'Antialiasing',
  Frame: 'Fotograma',
  Technique: 'Técnica',
  'What the picture is drawn by, and what of it is shown.': 'Con qué se dibuja la imagen y qué se muestra de ella.',
  'Technique of the frame': 'Técnica del fotograma',
  'View of the frame': 'Vista del fotograma',
  Lights: 'Luces',
  '{visible} of {total} in view': '{visible} de {total} a la vista',
  Draws: 'Llamadas de dibujo',
  Triangles: 'Triángulos',
  Programs: 'Programas',
  Targets: 'Destinos',
  Sent: 'Enviado',
  '{kilobytes} kB a frame': '{kilobytes} kB por fotograma',
  'Why this technique': 'Por qué esta técnica',
  'Scale: from 0, black, to {heatMapMaximum} and more, red': 'Escala: de 0, negro, a {heatMapMaximum} o más, rojo',
  'Draws a pixel': 'Dibujos por píxel',
  'Lights a pixel': 'Luces por píxel',
  'Where the two techniques meet': 'Donde se encuentran las dos técnicas',
  Passes: 'Pasadas',
  'Time of each pass over the last 120 frames.': 'Tiempo de cada pasada en los últimos 120 fotogramas.',
  'Times of': 'Tiempos de',
  '{processor} time of each pass over the last frames; the means are in the table below':
    'Tiempo de {processor} de cada pasada en los últimos fotogramas; las medias están en la tabla de abajo',
  Pass: 'Pasada',
  Views: 'Vistas',
  'Everything that the frame is made of.': 'Todo de lo que se compone el fotograma.',
  'All views at once': 'Todas las vistas a la vez',
  'Views of surfaces, light and counts beside one another; a click on one shows it alone.':
    'Vistas de superficies, luz y recuentos, unas junto a otras; un clic muestra solo esa.',
  'Heat map maximum': 'Máximo del mapa de calor',
  'Lights, or draws, a pixel at which light count and overdraw are red.':
    'Luces, o llamadas de dibujo, por píxel con los que el número de luces y el sobredibujado son rojos.',
  'at rest': 'en reposo',
  '{visible} of {total}': '{visible} de {total}',
  '{shown} light': '{shown} luz',
  '{shown} lights': '{shown} luces',
  '{shown} draw': '{shown} dibujo',
  '{shown} draws': '{shown} llamadas de dibujo',
  '{shown} triangle': '{shown} triángulo',
  '{shown} triangles': '{shown} triángulos',
  'Time of each pass of the last frame (ms)': 'Tiempo de cada pasada del último fotograma (ms)',
  'not told': 'sin datos',
  Geometries: 'Geometrías',
  'Picks the fastest technique for what is in view, and says why.':
    'Elige la técnica más rápida para lo que está a la vista; las cifras dicen cuál y por qué.',
  'Forward, multipass': 'Forward, varias pasadas',
  'An additive pass for each light over the objects it reaches.':
    'Luz ambiente y emisión una vez; después, una pasada aditiva por cada luz sobre los objetos que alcanza.',
  'Forward, single pass': 'Forward, una pasada',
  'Each object once, by a loop over all lights.': 'Cada objeto una vez; su shader recorre todas las luces.',
  'Deferred shading': 'Sombreado diferido',
  'Surfaces into a G-buffer, then each light over the pixels of its volume.':
    'Las superficies a un G-buffer una vez; después, cada luz sobre los píxeles de su volumen.',
  'Light pre-pass': 'Light pre-pass',
  'Normals, then the lights into a buffer, then the materials, lit by that buffer.':
    'Primero las normales, después las luces a un búfer y al final los materiales, iluminados por ese búfer.',
  'Inferred lighting': 'Iluminación inferida',
  'Light pre-pass at half the resolution, joined by a filter that keeps edges.':
    'Light pre-pass con los búferes a media resolución, unidos por un filtro que respeta los bordes.',
  'Tiled deferred': 'Diferido por tiles',
  'A light list for each tile, within its depths, over a G-buffer.':
    'Una lista de luces por tile, entre sus profundidades, sobre un G-buffer.',
  'Tiled forward': 'Forward por tiles',
  'A light list for each tile, walked by the materials.':
    'Una lista de luces por tile, que recorren los propios materiales.',
  'Forward+': 'Forward+',
  'Depth, then a light list for each tile, within its depths, walked by the materials.':
    'Primero la profundidad; después, listas de luces entre las profundidades de cada tile, que recorren los materiales.',
  'Clustered deferred': 'Diferido por clústeres',
  'Light lists by tile and depth, over a G-buffer.': 'Listas de luces por tile y profundidad, sobre un G-buffer.',
  'Clustered forward': 'Forward por clústeres',
  'Light lists by tile and depth, walked by the materials.':
    'Listas de luces por tile y profundidad, que recorren los propios materiales.',
  Final: 'Final',
  Albedo: 'Albedo',
  Normal: 'Normales',
  Depth: 'Profundidad',
  Lighting: 'Iluminación',
  'Light count': 'Número de luces',
  Overdraw: 'Sobredibujado',
  Motion: 'Movimiento',
  'Reactive mask': 'Máscara reactiva',
  'Light buffer': 'Búfer de luz',
  'Shadow atlas': 'Atlas de sombras',
  'Image atlas': 'Atlas de imágenes',
  'Fog light': 'Luz de la niebla',
  'Fog transmittance': 'Transmitancia de la niebla',
  Froxels: 'Fróxeles',
  'few lights over a pixel: a G-buffer costs more than it saves':
    'pocas luces por píxel: un G-buffer costaría más de lo que ahorra',
  'many lights over a pixel: each surface is lit once, by the list of its cluster':
    'muchas luces por píxel: cada superficie se ilumina una vez, con la lista de su clúster',
  'surfaces hide one another: depth is drawn first, so that each pixel is shaded once':
    'unas superficies tapan a otras: primero se dibuja la profundidad, y cada píxel se sombrea una sola vez',
  'very many lights over a pixel: each surface is lit once, by the list of its tile':
    'muchísimas luces, muchas por píxel: cada superficie se ilumina una vez, con la lista de su tile, hecha en la GPU',
  Vignette: 'Viñeta',
  'Tiled deferred shading that grows dark towards the edges: an example of a plugin.':
    'Diferido por tiles que se oscurece hacia los bordes: un ejemplo de complemento.',
  'surfaces hide one another: depth is drawn first, so that each pixel is shaded once':
    'unas superficies tapan a otras: primero se dibuja la profundidad, y cada píxel se ilumina una sola vez',
  'few lights: lists cost more than they save': 'casi ninguna luz: las listas costarían más de lo que ahorran',
  'What the effects cost': 'Lo que cuestan los efectos',
  Effect: 'Efecto',
};
