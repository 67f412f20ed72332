import type { Texts } from '@farol/editing';

/** Spanish texts of sky, tone mapping and effects. */
export const picture: Texts = {
  'Tone mapping': 'Mapeo de tonos',
  'Exposure compensation': 'Compensación de exposición',
  'Exposure compensation: 1 is twice the light, -1 half of it. Needs a tone mapping.':
    'Pasos de exposición además del resto: 1 es el doble de luz, -1 la mitad. Requiere un mapeo de tonos.',
  'Depth of field': 'Profundidad de campo',
  'Depth of field: the scene’s, none, or one of this camera.':
    'Profundidad de campo: la de la escena, ninguna o una propia de esta cámara.',
  'Focus distance': 'Distancia de enfoque',
  'Focus range': 'Intervalo de enfoque',
  'How far from the focus things are as blurred as they become.':
    'A qué distancia del enfoque el desenfoque es máximo.',
  'Blur strength': 'Fuerza del desenfoque',
  'How blurred things far from the focus are.': 'Cuánto se desenfoca lo que está lejos del enfoque.',
  Preset: 'Preajuste',
  'A sky that is made in code.': 'Un cielo generado por código.',
  'Colour straight above.': 'Color justo encima.',
  Horizon: 'Horizonte',
  'Colour at the horizon.': 'Color en el horizonte.',
  Ground: 'Suelo',
  'Colour straight below.': 'Color justo debajo.',
  'Light from the sky': 'Luz del cielo',
  'The sky lights every standard and physical material from all sides.':
    'El cielo ilumina por todos lados los materiales estándar y físicos.',
  'Factor of the light that comes from the environment or the sky, and of how bright it is seen.':
    'Factor de la luz que viene del entorno o del cielo, y de lo brillante que se ve.',
  'Background intensity': 'Intensidad del fondo',
  'Factor of how bright the sky is seen; it lights the scene the same.':
    'Factor de lo brillante que se ve el cielo; la escena se ilumina igual.',
  'Turns environment and sky about the vertical.': 'Gira entorno y cielo en torno a la vertical.',
  Blur: 'Desenfoque',
  'How blurred the sky is seen; 0 is sharp.': 'Cuánto se desenfoca el cielo; 0 es nítido.',
  'Colour from the sky': 'Color del cielo',
  'The fog has the colour of the sky at the horizon, or of the background.':
    'La niebla toma el color del cielo en el horizonte, o el del fondo.',
  'How light of any brightness becomes colours of a screen; three’s tone mappings.':
    'Cómo la luz de cualquier intensidad pasa a colores de pantalla; los mapeos de tonos de three.',
  'Factor of all light before it is tone mapped.': 'Factor de toda la luz antes del mapeo de tonos.',
  Bloom: 'Resplandor',
  'Bright things glow over their surroundings.': 'Lo brillante resplandece sobre lo que tiene al lado.',
  Strength: 'Fuerza',
  'How much they glow.': 'Cuánto resplandece.',
  Threshold: 'Umbral',
  'Luminance from which on things glow; 1 is a white surface in full light.':
    'Luminancia desde la que hay resplandor; 1 es una superficie blanca a plena luz.',
  Radius: 'Radio',
  'How far it reaches.': 'Hasta dónde llega.',
  'What is nearer or farther than the focus is blurred. A camera can have its own.':
    'Lo que está más cerca o más lejos del enfoque se ve borroso. Cada cámara puede tener la suya.',
  'Distance from the camera at which things are sharp.': 'Distancia a la cámara de lo que se ve nítido.',
  'Colour grading': 'Gradación de color',
  'Changes the colours of the finished picture.': 'Cambia los colores de la imagen terminada.',
  Temperature: 'Temperatura',
  'Below 0 cooler, above 0 warmer.': 'Por debajo de 0 más fría, por encima más cálida.',
  Tint: 'Tinte',
  'Below 0 greener, above 0 more magenta.': 'Por debajo de 0 más verde, por encima más magenta.',
  Contrast: 'Contraste',
  'Below 0 flatter, above 0 stronger.': 'Por debajo de 0 más suave, por encima más fuerte.',
  Saturation: 'Saturación',
  '-1 is grey, above 0 more colourful.': '-1 es gris, por encima de 0 más color.',
  'Look-up table': 'Tabla de colores',
  'Table of colours (LUT): a .cube file, or an image of its slices in a row.':
    'Tabla de colores (LUT): un archivo .cube, o una imagen con sus cortes en fila.',
  'Table strength': 'Fuerza de la tabla',
  'How much of the look-up table is seen.': 'Cuánto se ve de la tabla de colores.',
  'The picture darkens towards its corners.': 'La imagen se oscurece hacia las esquinas.',
  Darkness: 'Oscuridad',
  'How dark the corners are.': 'Lo oscuras que son las esquinas.',
  Reach: 'Extensión',
  'How far it reaches into the picture.': 'Hasta dónde entra en la imagen.',
  'How the scene is lit and drawn; "Automatic" picks the fastest.':
    'Con qué se dibuja la escena; «Automático» elige lo más rápido.',
  'Lite holds less memory for surfaces and shadows. Automatic takes it on phones and weak devices.':
    '«Ligera» ocupa menos memoria para superficies y sombras. «Automático» lo elige en teléfonos y equipos modestos.',
  'Fog scattering': 'Dispersión de la niebla',
  'Share of light that the fog scatters; the rest is absorbed.':
    'Parte de la luz que la niebla dispersa; absorbe el resto.',
  'Effects of plugins': 'Efectos de complementos',
  'Names of effects of plugins that are on, with commas between them.':
    'Nombres de los efectos de complementos activados, separados por comas.',
  'Set effects': 'Elegir los efectos',
  'The background, and the light from it.': 'Lo que se ve detrás de los objetos, y los ilumina.',
  'How objects fade with distance.': 'Cómo se funden los objetos con la distancia.',
  'Volumetric fog is off: fog volumes are not drawn. Switch it on among the effects.':
    'La niebla volumétrica está apagada: los volúmenes de niebla no se ven. Actívala entre los efectos.',
  'How light becomes a picture.': 'Cómo la luz se convierte en imagen.',
  'Picture effects': 'Efectos de imagen',
  'Effects on the finished picture.': 'Lo que se hace a la imagen terminada.',
  'This technique has no depth before it lights, so {effect} is left out. {names} have it.':
    'Esta técnica no conoce la profundidad antes de sombrear: no hay {effect}. La tienen: {names}.',
  'This technique has no G-buffer, so {effect} is left out. {names} have it.':
    'Esta técnica no tiene G-buffer: no hay {effect}. La tienen: {names}.',
  'This technique shades one sample a pixel: edges are jagged. Automatic smooths them by SMAA.':
    'Esta técnica sombrea una muestra por píxel: los bordes quedan dentados. Automático los suaviza con SMAA.',
  'This technique has no G-buffer: decals are not drawn. Automatic picks one that has it.':
    'Esta técnica no tiene G-buffer: las calcomanías no se ven. Automático elige una que sí.',
  'Tone mapping of what this camera sees.': 'Mapeo de tonos de lo que ve esta cámara.',
  'How edges are smoothed. Automatic is multisampled where the technique can be, else SMAA; TAA gathers frames.':
    'Cómo se suavizan los bordes. Automático usa multimuestreo donde la técnica lo permite y, si no, SMAA; TAA acumula fotogramas.',
  'Whether the scene is drawn smaller, and enlarged, where its frames would take longer than 16.7 ms.':
    'Si la escena se dibuja más pequeña, y se amplía, cuando sus fotogramas tardarían más de 16.7 ms.',
  'the time of a frame is not known yet': 'aún no se sabe cuánto tarda un fotograma',
  'frames take the time of the budget at this scale': 'a esta escala los fotogramas cumplen el presupuesto',
  'frames took longer than the budget': 'los fotogramas tardaban más de lo previsto',
  'frames took less than the budget': 'los fotogramas tardaban menos de lo previsto',
  'frames take longer than the budget at the least scale': 'ni a la escala mínima bastan',
  'frames take less than the budget at the largest scale': 'a la escala máxima sobra tiempo',
  'a larger scale is tried': 'se prueba una escala mayor',
  "three's effects read its output buffer": 'hay efectos de three en su búfer de salida',
  'the target has several textures': 'el destino tiene varias texturas',
  'the target is part of a cube, an array or mipmaps': 'el destino es parte de un cubo, una serie o mipmaps',
  'the picture is small': 'la imagen es pequeña',
  'Of the scene': 'De la escena',
  Reinhard: 'Reinhard',
  Cineon: 'Cineon',
  'ACES filmic': 'ACES fílmico',
  AgX: 'AgX',
  Neutral: 'Neutro',
  Off: 'Desactivada',
  Own: 'Propia',
  Gradient: 'Degradado',
  'Clear day': 'Día despejado',
  Overcast: 'Nublado',
  Sunset: 'Atardecer',
  Studio: 'Estudio',
  Exponential: 'Exponencial',
  'Of the technique': 'De la técnica',
  'Set technique to {name}': 'Elegir la técnica {name}',
  'Picture effects: bloom, depth of field, grading, vignette':
    'Efectos de imagen: resplandor, profundidad de campo, gradación, viñeta',
  'Place the sun': 'Situar el sol',
  'Put the sun, or the moon, where two angles say, not where the preset has it.':
    'Pone el sol o la luna donde dicen dos ángulos, no donde lo tiene el cielo elegido.',
  'Sun azimuth': 'Azimut del sol',
  'Direction of the sun on the compass, from +x towards +z.': 'Dirección del sol en la brújula, de +x hacia +z.',
  'Sun elevation': 'Altura del sol',
  'How high the sun stands above the horizon.': 'A qué altura está el sol sobre el horizonte.',
  'Save a picture…': 'Guardar una imagen…',
  'Save a picture': 'Guardar una imagen',
  'The scene as it is seen now, without grid, icons and handles, as a PNG.':
    'La escena como se ve ahora, sin rejilla, iconos ni asas, como PNG.',
  'As shown': 'Como se ve',
  'Without background': 'Sin fondo',
  'With bloom, depth of field, vignette or automatic exposure at most {count} pixels a side.':
    'Con resplandor, profundidad de campo, viñeta o exposición automática, {count} píxeles por lado como máximo.',
  'Drawing the picture': 'Dibujando la imagen',
  'Saved {fileName}': 'Se guardó {fileName}',
  'The graphics device was lost while the picture was drawn: save it again.':
    'El dispositivo gráfico se perdió mientras se dibujaba la imagen: guárdela otra vez.',
  'Save a film…': 'Guardar una película…',
  'Save a film': 'Guardar una película',
  'Every frame is drawn as a picture of its time, however long it takes. Without sound.':
    'Cada fotograma se dibuja como una imagen de su instante, tarde lo que tarde. Sin sonido.',
  'The view as shown': 'La vista como se ve',
  'The scene’s camera': 'La cámara de la escena',
  'Follows scripts that switch cameras.': 'También cuando un script elige otra.',
  'Through the stored views': 'Por las vistas guardadas',
  'A smooth path in their order.': 'Un recorrido suave, en su orden.',
  Turntable: 'Plataforma giratoria',
  'Around the selection or the scene, from the current view.':
    'Alrededor de la selección, o de la escena, desde la vista actual.',
  'The scene plays': 'La escena se reproduce',
  Turns: 'Vueltas',
  From: 'Desde',
  To: 'Hasta',
  'Other…': 'Otra…',
  'Other rate': 'Otra frecuencia',
  Format: 'Formato',
  'PNG frames (ZIP)': 'Fotogramas PNG (ZIP)',
  'Small file': 'Archivo pequeño',
  Good: 'Buena',
  High: 'Alta',
  Bitrate: 'Tasa de bits',
  '{count} frames, {seconds} s': '{count} fotogramas, {seconds} s',
  '{count} frames, {seconds} s, about {size} MB': '{count} fotogramas, {seconds} s, unos {size} MB',
  'The film ends before it begins: raise “To”.': 'La película acaba antes de empezar: hay que aumentar «Hasta».',
  'A ZIP holds {count} frames: choose a shorter film.':
    'En un ZIP caben {count} fotogramas: hay que elegir una película más corta.',
  'The film would have more than the 4 GB of a ZIP: choose a smaller size or a shorter film.':
    'La película pasaría de los 4 GB de un ZIP: hay que elegir un tamaño menor o una película más corta.',
  'This browser does not encode video here (WebCodecs needs https and a new browser): choose PNG frames.':
    'Este navegador no codifica vídeo aquí (WebCodecs exige https y un navegador nuevo): hay que elegir fotogramas PNG.',
  '{format} needs an even width and height, such as {width} × {height}.':
    '{format} exige anchura y altura pares, como {width} × {height}.',
  'This browser does not encode {format} at {width} × {height}: choose another format or a smaller size.':
    'Este navegador no codifica {format} a {width} × {height}: hay que elegir otro formato o un tamaño menor.',
  'The browser could not go on encoding {format}: choose another format.':
    'El navegador no pudo seguir codificando {format}: hay que elegir otro formato.',
  'This browser makes no PNG of {width} × {height}: choose a smaller size.':
    'Este navegador no hace PNG de {width} × {height}: hay que elegir un tamaño menor.',
  'There is nothing to turn around: add an object first.':
    'No hay nada alrededor de lo que girar: hay que añadir antes un objeto.',
  'A path needs two stored views: Ctrl with a number stores one.':
    'Un recorrido necesita dos vistas guardadas: Ctrl con un número guarda una.',
  'The scene has no such camera any more: choose another one.': 'La escena no tiene esa cámara: se elige otra.',
  'Another scene was opened while the film was made: make it again.':
    'Se abrió otra escena mientras se hacía la película: hay que hacerla otra vez.',
  Film: 'Película',
  'Making the film': 'Haciendo la película',
  'Frame {frame} of {count}': 'Fotograma {frame} de {count}',
  'Frame {frame} of {count}, about {left} left': 'Fotograma {frame} de {count}, faltan unos {left}',
  'Use this view as the scene’s picture': 'Usar esta vista como imagen de la escena',
  'Chose the scene’s picture': 'Elegida la imagen de la escena',
  'This view is the scene’s picture: lists of files show it once the scene is saved.':
    'Esta vista es la imagen de la escena: las listas de archivos la muestran cuando se guarda.',
  'No picture could be made: show the panel Viewport and try again.':
    'No se pudo hacer una imagen: hay que mostrar el panel Vista 3D y probar de nuevo.',
};
