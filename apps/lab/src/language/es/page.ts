import type { Texts } from '@farol/editing';

/** Spanish texts of the page: device, builder, progress, words of cases and competitors. */
export const page: Texts = {
  Graphics: 'Gráficos',
  Browser: 'Navegador',
  'GPU time': 'tiempo de GPU',
  'by timer queries': 'con temporizador',
  'no timer here: whole frames are measured': 'aquí no hay temporizador: se miden fotogramas enteros',
  WebGPU: 'WebGPU',
  'The browser draws on the processor here, by a software rasteriser, not on a graphics card: the button measures small pictures, and the figures say nothing about GPUs. Switch hardware acceleration on in the browser’s settings.':
    'El navegador dibuja aquí con el procesador, por un rasterizador por software, no con una tarjeta gráfica: el botón mide imágenes pequeñas y las cifras no dicen nada de las GPU. La aceleración por hardware se activa en los ajustes del navegador.',
  'Which way of lighting is fastest on your machine?': '¿Qué forma de iluminar es la más rápida en tu equipo?',
  'The Lab draws the same scenes by eleven techniques of Farol, by three.js and by other engines, in turns, and shows which is fastest where.':
    'El Lab dibuja las mismas escenas con once técnicas de Farol, con three.js y con otros motores, por turnos, y muestra cuál es la más rápida en cada caso.',
  'Measure this machine (90 s)': 'Medir este equipo (90 s)',
  'Waiting for the scene of the page that opened the Lab …': 'Esperando la escena de la página que abrió el Lab …',
  'Opening the frames that are measured …': 'Abriendo los marcos que se miden …',
  'Handed over, to be measured:': 'Recibida para medirla:',
  Results: 'Resultados',
  'Farol Lab cannot measure here': 'Farol Lab no puede medir aquí',
  'This browser has no WebGL 2: use Chrome, Edge or Firefox of the last two years, or Safari 17 or newer.':
    'Este navegador no tiene WebGL 2: hace falta Chrome, Edge o Firefox de los últimos dos años, o Safari 17 o posterior.',
  'WebGL 2 is switched off here: switch hardware acceleration on in the browser’s settings, or update the graphics driver, then load the page again.':
    'WebGL 2 está desactivado aquí: hay que activar la aceleración por hardware en los ajustes del navegador, o actualizar el controlador gráfico, y volver a cargar la página.',
  'Normals that a file lacks': 'Normales que le faltan a un archivo',
  'Sponza, as it was handed round in 2015, came without normals; figure 4.3 of the thesis that Farol grew from shows what computed ones did to its arches. Here the atrium’s normals are taken off and computed again in two ways, under 50 lights, on your machine.':
    'Sponza, tal como circulaba en 2015, venía sin normales; la figura 4.3 de la tesis de la que nació Farol muestra lo que las calculadas hicieron con sus arcos. Aquí se quitan las normales del atrio y se vuelven a calcular de dos maneras, bajo 50 luces, en tu equipo.',
  'Not drawn yet': 'Aún sin dibujar',
  'Drawing …': 'Dibujando …',
  'none##of the corners': 'ninguno',
  'less than 1%': 'menos del 1 %',
  'takes about': 'tarda unos',
  'working out how long': 'calculando cuánto falta',
  'about {time} left': 'faltan unos {time}',
  '{percent}% measured, {left}.': '{percent} % medido, {left}.',
  'Last picture': 'Última imagen',
  'Measuring: {label}': 'Midiendo: {label}',
  'ending …': 'terminando …',
  'Comparing pictures': 'Comparando imágenes',
  'The tab is hidden, so the run waits: browsers throttle hidden tabs.':
    'La pestaña está oculta y la medición espera: los navegadores frenan las pestañas ocultas.',
  'Keep this tab in front, and let the machine do nothing else.':
    'Conviene dejar esta pestaña delante y que el equipo no haga nada más.',
  'and keep what was measured': 'y conservar lo medido',
  'your own comparison': 'tu propia comparación',
  'What to measure': 'Qué medir',
  'Build your own': 'Componer una propia',
  'Measure: {label}': 'Medir: {label}',
  'What a thesis of 2015 concluded, and what holds today':
    'Lo que concluyó una tesis de 2015 y lo que sigue siendo cierto',
  'Farol grew from a thesis that compared forward with deferred shading in 2015. The figures are those of the reference run on an NVIDIA H200 at 1280 × 720, November 2026: medians of frame times, forward by the thesis’s own algorithm (the whole scene drawn once per light, here “three: naive multipass”) against Farol’s deferred. Five of seven conclusions hold.':
    'Farol nació de una tesis que comparó en 2015 forward con sombreado diferido. Las cifras son las de la medición de referencia en una NVIDIA H200 a 1280 × 720, en noviembre de 2026: medianas del tiempo de fotograma, forward con el algoritmo de la tesis (la escena entera una vez por luz, aquí «three: varias pasadas sin más») frente al diferido de Farol. Cinco de siete conclusiones siguen siendo ciertas.',
  'Farol’s own forward technique draws each light over the objects within its range alone. With a single light over a plane it is slower than naive multipass (0.776 against 0.525 ms), with 500 lights in the atrium far faster: 97.4 against 549 ms, where deferred takes 6.46 ms.':
    'La técnica forward de Farol dibuja cada luz solo sobre los objetos que alcanza. Con una sola luz sobre un plano es más lenta que las varias pasadas sin más (0.776 frente a 0.525 ms); con 500 luces en el atrio, mucho más rápida: 97.4 frente a 549 ms, donde el diferido tarda 6.46 ms.',
  Choices: 'Opciones',
  'Add a chart': 'Añadir un gráfico',
  'Who is measured': 'A quién se mide',
  All: 'Todos',
  'of {group}': 'de {group}',
  'How thoroughly': 'Con cuánto detalle',
  'Turns for each': 'Turnos de cada uno',
  'A turn': 'Un turno',
  'Leave out frames over': 'Omitir fotogramas de más de',
  'The whole run': 'La medición entera',
  'Shorten turns so that the run ends in time': 'Acortar los turnos para terminar a tiempo',
  'Measure what a change costs: ten lights more, another technique':
    'Medir lo que cuesta un cambio: diez luces más, otra técnica',
  'Install PlayCanvas and Babylon.js': 'Instalar PlayCanvas y Babylon.js',
  'npm fetches them for the Lab alone: 200 MB on disk.': 'npm los descarga solo para el Lab: 200 MB en disco.',
  'npm fetches them: some seconds to minutes, by the network.':
    'npm los está descargando: de segundos a minutos, según la red.',
  'They are installed: reload the page to measure them.': 'Están instalados: hay que recargar la página para medirlos.',
  'From {min} to {max}, whole.': 'De {min} a {max}, entero.',
  'From {min} to {max}.': 'De {min} a {max}.',
  'Chart {number}': 'Gráfico {number}',
  'Remove chart {number}': 'Quitar el gráfico {number}',
  'What changes': 'Qué cambia',
  'Planes along a side': 'Planos por lado',
  'Kind of lights': 'Tipo de luces',
  'Reach of a light': 'Alcance de una luz',
  'The scene’s': 'El de la escena',
  'As many lights as planes': 'Tantas luces como planos',
  'Values: {unit}, in thousands': 'Valores: {unit}, en miles',
  'Values: {unit}': 'Valores: {unit}',
  'Picture (pixels)': 'Imagen (píxeles)',
  'Give at least one value, as in 10, 100, 1000.': 'Hace falta al menos un valor, como en 10, 100, 1000.',
  '“{word}” is no whole number: write 10, 100, 1000.': '«{word}» no es un número entero: se escribe 10, 100, 1000.',
  '{word} is too large: a million at most.': '{word} es demasiado: un millón como mucho.',
  '{count} values are too many: {most} at most.': '{count} valores son demasiados: {most} como mucho.',
  'Close the comparison': 'Cerrar la comparación',
  ': equal': ': igual',
  'The reference, drawn by {name}': 'La referencia, dibujada por {name}',
  'Reference: {name}': 'Referencia: {name}',
  'Difference of the pictures': 'Diferencia de las imágenes',
  'Difference, {factor} times brighter; black where both are equal':
    'Diferencia, {factor} veces más clara; negra donde ambas son iguales',
  'The reference, drawn by {name}, is not among the pictures.':
    'La referencia, dibujada por {name}, no está entre las imágenes.',
  'These are the small pictures that a run keeps; the difference shows their compression too. Right after a run the pictures are shown as they were drawn.':
    'Son las imágenes pequeñas que guarda una medición; la diferencia muestra también su compresión. Justo después de medir, las imágenes se ven como se dibujaron.',
  'This run keeps no pictures.': 'Esta medición no guarda imágenes.',
  '{count} lights left out': '{count} luces omitidas',
  'the reference': 'la referencia',
  'equal to the reference': 'igual a la referencia',
  'The first figures come in some seconds.': 'Las primeras cifras llegan en unos segundos.',
  'Nothing was measured.': 'No se midió nada.',
  'What each one drew': 'Lo que dibujó cada uno',
  'All measurements': 'Todas las medidas',
  'Table of {count} rows, with warnings and what failed': 'Tabla de {count} filas, con avisos y lo que falló',
  'So far': 'Hasta ahora',
  'reference, not your machine': 'referencia, no es tu equipo',
  '; took {time}': '; duró {time}',
  Chart: 'Gráfico',
  '{count} rows': '{count} filas',
  '{count} of {all} rows': '{count} de {all} filas',
  'All rows': 'Todas las filas',
  'Technique or renderer that drew.': 'Técnica o motor que dibujó.',
  Remarks: 'Observaciones',
  '{count} lights are left out of its picture.': 'En su imagen faltan {count} luces.',
  'Measure the same here': 'Medir lo mismo aquí',
  'Measure again': 'Medir otra vez',
  'Compare with the reference': 'Comparar con la referencia',
  '{count} compiled': '{count} compilados',
  'its own': 'las suyas',
  '{count} shadowed': '{count} con sombra',
  equal: 'igual',
  'This run was cancelled before anything was measured, and is not kept.':
    'Esta medición se canceló antes de medir nada y no se guarda.',
  'The time for the run was over before every case was measured: give it more under “How thoroughly”, or measure less.':
    'El tiempo se acabó antes de medir todos los casos: se le puede dar más en «Con cuánto detalle», o medir menos.',
  'This run was cancelled: what was measured until then is kept and shown.':
    'Esta medición se canceló: lo medido hasta entonces se guarda y se muestra.',
  'The scene that was handed over is not here: choose “Measure this scene” in the editor or the viewer, or another scene.':
    'La escena recibida ya no está: hay que elegir «Medir esta escena» en el editor o el visor, u otra escena.',
  '{cases} × {competitors}, about {time}': '{cases} × {competitors}, unos {time}',
  '{count} case': '{count} caso',
  '{count} cases': '{count} casos',
  '{count} competitor': '{count} participante',
  '{count} competitors': '{count} participantes',
  'No GPU times: a software rasteriser draws on the processor.':
    'Sin tiempos de GPU: un rasterizador por software dibuja con el procesador.',
  'No GPU times: the device or the browser has no timer queries.':
    'Sin tiempos de GPU: el dispositivo o el navegador no tiene temporizador.',
  'No CPU times were measured.': 'No se midieron tiempos de CPU.',
  'No frame times were measured.': 'No se midieron tiempos de fotograma.',
  '{factor} times': '{factor} veces',
  '{list} and {last}': '{list} y {last}',
  'by {time}': 'por {time}',
  '{scene} over {axis}': '{scene} según {axis}',
  'reach {range} m': 'alcance {range} m',
  '{count} lights': '{count} luces',
  'as many lights as planes': 'tantas luces como planos',
  'Farol: lite': 'Farol: ligera',
  'Automatic, with the quality ‘lite’.': 'Automático, con la calidad «ligera».',
  'three: WebGLRenderer': 'three: WebGLRenderer',
  'All lights as uniforms of one loop; compiled anew for each number of lights.':
    'Todas las luces como uniformes de un bucle; se compila de nuevo con cada número de luces.',
  'three: naive multipass': 'three: varias pasadas sin más',
  'The whole scene drawn once more, additively, for each light.':
    'La escena entera dibujada otra vez, sumando, por cada luz.',
  'three: WebGPU, clustered': 'three: WebGPU, por clústeres',
  'WebGPURenderer with the ClusteredLighting addon.': 'WebGPURenderer con el complemento ClusteredLighting.',
  'PlayCanvas, clustered': 'PlayCanvas, por clústeres',
  'PlayCanvas’s clustered lights on WebGL 2.': 'Las luces por clústeres de PlayCanvas en WebGL 2.',
  'Babylon.js, clustered': 'Babylon.js, por clústeres',
  'Babylon’s ClusteredLightContainer on WebGL 2.': 'El ClusteredLightContainer de Babylon en WebGL 2.',
  Quick: 'Rápida',
  'Planes and the atrium, from few lights to a thousand, by every technique.':
    'Planos y el atrio, de pocas luces a mil, con todas las técnicas.',
  'The thesis': 'La tesis',
  'The measurements of 2015 by the thesis that Farol grew from, row by row.':
    'Las mediciones de 2015 de la tesis de la que nació Farol, fila a fila.',
  'From ten lights to ten thousand, in the atrium and the temple.':
    'De diez luces a diez mil, en el atrio y el templo.',
  Objects: 'Objetos',
  'One plane to 2,500 under 100 lights.': 'De un plano a 2500 bajo 100 luces.',
  'The atrium from 640 × 360 to 3840 × 2160, with few and with many lights.':
    'El atrio de 640 × 360 a 3840 × 2160, con pocas y con muchas luces.',
  'Layers one behind the other, from back to front, under 100 lights.':
    'Capas una tras otra, de atrás adelante, bajo 100 luces.',
  'The atrium with 64 lights, of which more and more cast shadows.':
    'El atrio con 64 luces, de las que cada vez más proyectan sombras.',
  'Light and matter': 'Luz y materia',
  'In the atrium: particles and fields of thousands of lights, rectangles beside points, flat, Gouraud and Phong shading.':
    'En el atrio: partículas y campos de miles de luces, rectángulos junto a puntos, sombreado plano, Gouraud y Phong.',
  Regression: 'Regresión',
  'The cases by which commits are compared: planes and the atrium from one light to 20,000, fields, shadows.':
    'Los casos con los que se comparan versiones: planos y el atrio de una luz a 20 000, campos, sombras.',
  'First frames, ten lights more, another technique: the longest frame, and what is compiled in it.':
    'Primeros fotogramas, diez luces más, otra técnica: el fotograma más largo y lo que se compila en él.',
  'N × N planes that make a floor of 30 m × 30 m, lights just above it.':
    'N × N planos que forman un suelo de 30 m × 30 m, con luces justo encima.',
  Atrium: 'Atrio',
  'A hall of the scale of the Sponza palace: 100 meshes, 260,000 triangles.':
    'Una sala de la escala del palacio Sponza: 100 mallas, 260 000 triángulos.',
  'A Doric temple on a green plane, with six spot lights beside the moving lights.':
    'Un templo dórico sobre un plano verde, con seis focos además de las luces en movimiento.',
  'Your scene': 'Tu escena',
  'The scene that the editor or the viewer handed over.': 'La escena que entregó el editor o el visor.',
  'Point lights': 'Luces puntuales',
  points: 'puntos',
  'PointLights of three.js.': 'PointLight de three.js.',
  'Spot lights': 'Focos',
  spots: 'focos',
  'SpotLights of three.js that shine down, with soft edges.':
    'SpotLight de three.js que alumbran hacia abajo, con bordes suaves.',
  Rectangles: 'Rectángulos',
  rectangles: 'rectángulos',
  'RectAreaLights of 40 cm × 25 cm that shine down; those of Farol end where the points do.':
    'RectAreaLight de 40 cm × 25 cm que alumbran hacia abajo; las de Farol terminan donde los puntos.',
  Profiles: 'Perfiles',
  'points with profiles': 'puntos con perfiles',
  'Point lights shaped by three photometric profiles: downlight, wall washer, street light.':
    'Luces puntuales con tres perfiles fotométricos: empotrada, bañador de pared, farola.',
  LightField: 'LightField',
  'a LightField': 'un LightField',
  'Point lights as data of one object; all of them move, so all are sent in each frame.':
    'Luces puntuales como datos de un objeto; todas se mueven, así que todas se envían en cada fotograma.',
  particles: 'partículas',
  'Each particle that the GPU moves is a light. The particles are drawn too.':
    'Cada partícula que mueve la GPU es una luz. Las partículas también se dibujan.',
  'As they are': 'Como son',
  'the materials’ own shading': 'el sombreado de los materiales',
  'Materials as the scene has them.': 'Los materiales como los tiene la escena.',
  'flat shading': 'sombreado plano',
  'One normal a triangle.': 'Una normal por triángulo.',
  'Gouraud shading': 'sombreado Gouraud',
  'Lit at the vertices, by forward draws.': 'Iluminado en los vértices, dibujando en forward.',
  'Phong shading': 'sombreado Phong',
  'Lit in each pixel, by interpolated normals.': 'Iluminado en cada píxel, con normales interpoladas.',
  lights: 'luces',
  objects: 'objetos',
  'Pixels of the picture': 'Píxeles de la imagen',
  pixels: 'píxeles',
  'Layers one behind the other': 'Capas una tras otra',
  layers: 'capas',
  'Lights that cast shadows': 'Luces que proyectan sombras',
  'shadowed lights': 'luces con sombra',
  'kind of lights': 'tipo de luces',
  shading: 'sombreado',
  'frame time': 'tiempo de fotograma',
  'Frames in batches, each batch waited for: CPU and GPU together.':
    'Fotogramas por tandas, esperando cada tanda: CPU y GPU juntas.',
  GPU: 'GPU',
  'GPU time of a frame, by timer query.': 'Tiempo de GPU de un fotograma, con temporizador.',
  CPU: 'CPU',
  'CPU time': 'tiempo de CPU',
  'Time inside the call that draws.': 'Tiempo dentro de la llamada que dibuja.',
  'Everything, pictures included: the Lab opens it again, on any machine.':
    'Todo, con imágenes: el Lab lo vuelve a abrir en cualquier equipo.',
  'A row for each case and competitor, for spreadsheets and scripts.':
    'Una fila por caso y participante, para hojas de cálculo y scripts.',
  'Tables as text, with all warnings.': 'Tablas como texto, con todos los avisos.',
  'Every chart as a drawing that can be enlarged, in an archive.':
    'Cada gráfico como dibujo que se puede ampliar, en un archivo comprimido.',
  'Every chart as a picture, in an archive.': 'Cada gráfico como imagen, en un archivo comprimido.',
  'single-pass forward': 'forward de una pasada',
  'three’s WebGLRenderer': 'el WebGLRenderer de three',
  'naive multipass': 'varias pasadas sin más',
  'three’s WebGPU': 'el WebGPU de three',
  PlayCanvas: 'PlayCanvas',
  'Babylon.js': 'Babylon.js',
  'Time of a frame': 'Tiempo de un fotograma',
  'CPU time in the call that draws': 'Tiempo de CPU en la llamada que dibuja',
  'With few lights over simple geometry, forward is faster.':
    'Con pocas luces sobre geometría sencilla, forward es más rápido.',
  'Holds in part': 'Cierto en parte',
  'One plane: 0.525 ms against 0.738 ms with 1 light, a tie with 4 lights (0.869 and 0.858 ms), and 3.34 ms against 1.23 ms with 25, where the thesis still saw forward ahead.':
    'Un plano: 0.525 ms frente a 0.738 ms con 1 luz, empate con 4 luces (0.869 y 0.858 ms) y 3.34 ms frente a 1.23 ms con 25, donde la tesis aún veía forward por delante.',
  'With 100 lights or more over a plane, forward falls behind deferred.':
    'Con 100 luces o más sobre un plano, forward queda por detrás del diferido.',
  Holds: 'Cierto',
  '12.2 ms against 1.38 ms with 100 lights, 26.2 ms against 1.49 ms with 225.':
    '12.2 ms frente a 1.38 ms con 100 luces, 26.2 ms frente a 1.49 ms con 225.',
  'With a mesh more complex than a plane, forward loses already with 10 lights.':
    'Con una malla más compleja que un plano, forward ya pierde con 10 luces.',
  'Atrium: 11.4 ms against 2.52 ms. Temple: 8.44 ms against 2.3 ms.':
    'Atrio: 11.4 ms frente a 2.52 ms. Templo: 8.44 ms frente a 2.3 ms.',
  'Deferred slows down less than forward as lights are added.':
    'El diferido se frena menos que forward al añadir luces.',
  'From 10 to 500 lights in the atrium forward takes 48 times as long, deferred 2.6 times; in the temple 40 and 2.5 times; over a plane, from 1 to 225 lights, 50 and 2 times.':
    'De 10 a 500 luces en el atrio, forward tarda 48 veces más y el diferido 2.6; en el templo, 40 y 2.5 veces; sobre un plano, de 1 a 225 luces, 50 y 2 veces.',
  'The G-buffer has a fixed cost: with little to light, deferred is slower.':
    'El G-buffer tiene un coste fijo: con poco que iluminar, el diferido es más lento.',
  'One plane, 1 light: deferred takes 0.213 ms more than forward. Its G-buffer takes 0.247 ms whether 1 or 225 lights follow.':
    'Un plano, 1 luz: el diferido tarda 0.213 ms más que forward. Su G-buffer tarda 0.247 ms, sigan 1 o 225 luces.',
  'With 500 lights, deferred falls below 15 frames per second.':
    'Con 500 luces, el diferido baja de 15 fotogramas por segundo.',
  'Holds no more': 'Ya no es cierto',
  '155 frames per second in the atrium and 172 in the temple, since this GPU is far faster than those of 2015.':
    '155 fotogramas por segundo en el atrio y 172 en el templo, porque esta GPU es mucho más rápida que las de 2015.',
  'Deferred draws many lights fluently where forward cannot.':
    'El diferido dibuja con fluidez muchas luces donde forward no puede.',
  'At 15 frames per second forward reaches 50 lights in the atrium and in the temple, deferred all 500. Tiled deferred, which the thesis left for later, draws 500 lights in the temple 1.91 times as fast as deferred.':
    'A 15 fotogramas por segundo, forward llega a 50 luces en el atrio y en el templo, el diferido a las 500. El diferido por tiles, que la tesis dejó para más adelante, dibuja 500 luces en el templo 1.91 veces más rápido que el diferido.',
  'By faces': 'Por caras',
  'Arcade whose blocks and medallions look soft, like cushions':
    'Arquería cuyos bloques y medallones se ven blandos, como cojines',
  'Each point takes the mean of all triangles that meet there, so edges are shaded as if they were round: the blocks under the gallery look like cushions, and the diagonals of triangles show as stripes. The normal leans from its triangle by more than 30° at {share} of the corners.':
    'Cada punto toma la media de todos los triángulos que se juntan en él, así que las aristas se sombrean como si fueran redondas: los bloques bajo la galería parecen cojines y las diagonales de los triángulos se ven como franjas. La normal se aparta de su triángulo más de 30° en {share} de los vértices.',
  'By crease angle': 'Por ángulo de arista',
  'The same arcade, whose blocks and medallions have sharp edges':
    'La misma arquería, cuyos bloques y medallones tienen aristas vivas',
  'Only triangles that meet at less than 30° share a normal: blocks and mouldings keep their edges, and columns and arches stay round. It leans by more at {share} of the corners.':
    'Solo los triángulos que se juntan con menos de 30° comparten normal: bloques y molduras conservan sus aristas, y columnas y arcos siguen redondos. Se aparta más en {share} de los vértices.',
  'Scene and axis.': 'Escena y eje.',
  'Value of the case along the x axis of its chart.': 'Valor del caso en el eje x de su gráfico.',
  'Width and height in pixels.': 'Ancho y alto en píxeles.',
  'Moving lights: number, kind, range, and how many cast shadows.':
    'Luces en movimiento: número, tipo, alcance y cuántas proyectan sombras.',
  'Shading of the materials, if not the scene’s own.': 'Sombreado de los materiales, si no es el de la escena.',
  'Likeness (dB)': 'Parecido (dB)',
  'PSNR of the picture against the reference; higher is more alike.':
    'PSNR de la imagen frente a la referencia; cuanto más alto, más parecidas.',
  '≈ marks a tie: the strip below a cell has the colours of those that tie with the shortest median.':
    '≈ marca un empate: la franja bajo una celda tiene los colores de quienes empatan con la mediana más corta.',
  'Ties within the spread: {names}': 'Empatan dentro de la dispersión: {names}',
  'Next: {name}, {time}': 'Después: {name}, {time}',
  'ties with {names}': 'empata con {names}',
  'GPU times': 'Tiempos de GPU',
  'Farol’s techniques': 'Técnicas de Farol',
  'Other engines': 'Otros motores',
  System: 'Sistema',
  Custom: 'A medida',
  'other passes': 'otras pasadas',
  'First frame': 'Primer fotograma',
  'Ten lights more': 'Diez luces más',
  'Technique changed': 'Técnica cambiada',
  Rasteriser: 'Rasterizador',
  'N × N planes, M × M lights': 'N × N planos, M × M luces',
  'Sponza (here: atrium)': 'Sponza (aquí: atrio)',
  Dark: 'Oscuro',
  light: 'luz',
  object: 'objeto',
  pixel: 'píxel',
  layer: 'capa',
  'shadowed light': 'luz con sombra',
  'kinds of lights': 'tipos de luces',
  shadings: 'sombreados',
  'Light##theme': 'Claro',
  'A whole frame: median, then the 10th and 90th percentile.': 'Un fotograma entero: mediana y percentiles 10 y 90.',
  'GPU (ms)': 'GPU (ms)',
  'Time on the graphics device, by timer queries.': 'Tiempo en el dispositivo gráfico, con temporizador.',
  'CPU (ms)': 'CPU (ms)',
  'Duration of the drawing call.': 'Duración de la llamada que dibuja.',
  'First frame (ms)': 'Primer fotograma (ms)',
  'The first frame, with compiling and uploads.': 'El primer fotograma, con compilación y envíos.',
  'Ten lights more (ms)': 'Diez luces más (ms)',
  'The frame after ten lights were added.': 'El fotograma que sigue a diez luces más.',
  'Technique changed (ms)': 'Técnica cambiada (ms)',
  'The frame after another technique was chosen and this one again.':
    'El fotograma que sigue a elegir otra técnica y de nuevo esta.',
  'Draw calls of a frame.': 'Llamadas de dibujo de un fotograma.',
  'Triangles of a frame.': 'Triángulos de un fotograma.',
  'Shader programs compiled for the case.': 'Programas de shaders compilados para el caso.',
  'Bytes of render targets and light data.': 'Bytes de destinos de dibujo y datos de luces.',
  Uploads: 'Envíos',
  'Bytes sent to the device in a frame.': 'Bytes enviados al dispositivo en un fotograma.',
  'On {device} (a reference, not your machine):': 'En {device} (una referencia, no es tu equipo):',
  'On {device}:': 'En {device}:',
  'Fastest, or as fast as the fastest, in {wins} of {cases} cases.':
    'La más rápida, o igual de rápida, en {wins} de {cases} casos.',
  'With up to {few} lights: {first}; with {many} or more: {second}.':
    'Con hasta {few} luces: {first}; con {many} o más: {second}.',
  'a tie: within the spread': 'empate: dentro de la dispersión',
  'To compare two runs, check the boxes before them.': 'Para comparar dos mediciones, se marcan sus casillas.',
  'What auto learnt on this device': 'Lo que auto aprendió en este dispositivo',
  'The technique “auto” picks another one by rules from one GPU. Here it measures those that it hesitates between, and keeps in this browser which is faster: pages of this address with the option “learning” go by that.':
    'La técnica «auto» elige otra con reglas sacadas de una sola GPU. Aquí mide aquellas entre las que duda y guarda en este navegador cuál es más rápida: las páginas de esta dirección con la opción «learning» se guían por eso.',
  'Let auto learn': 'Dejar que auto aprenda',
  'Forget all of it': 'Olvidarlo todo',
  'Nothing can be learnt here: there is no timer of the GPU.':
    'Aquí no se puede aprender nada: no hay temporizador de la GPU.',
  'Nothing yet.': 'Nada todavía.',
  '{count} verdict.': '{count} veredicto.',
  '{count} verdicts.': '{count} veredictos.',
  '{gpu}, from {lights} lights, {coverage} over a pixel, {pixels} pixels':
    '{gpu}, desde {lights} luces, {coverage} por píxel, {pixels} píxeles',
  '{a} and {b} are as fast': '{a} y {b} son igual de rápidas',
  '{a} is faster than {b}': '{a} es más rápida que {b}',
};
