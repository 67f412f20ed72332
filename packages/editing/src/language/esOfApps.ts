import type { Texts } from './translate';

/** Spanish texts that the editor, the viewer or the Lab share, by their English texts. */
export const esOfApps: Texts = {
  Help: 'Ayuda',
  Temple: 'Templo',
  Sponza: 'Sponza',
  'Nice scene': 'Escena bonita',
  Dragons: 'Dragones',
  'Planes and lights': 'Planos y luces',
  'Meshes and lights': 'Mallas y luces',
  'Measure this scene': 'Medir esta escena',
  Rename: 'Renombrar',
  Grid: 'Cuadrícula',
  Keys: 'Teclas',
  Space: 'Espacio',
  Theme: 'Tema',
  'Examples for your own page': 'Ejemplos para una página propia',
  Colours: 'Colores',
  Resolution: 'Resolución',
  Mesh: 'Malla',
  Shading: 'Sombreado',
  Linear: 'Lineal',
  Seed: 'Semilla',
  'Fog density': 'Densidad de la niebla',
  particles: 'partículas',
  '{count} lights': '{count} luces',
  'The texts of this language could not be loaded: reload the page.':
    'No se pudieron cargar los textos de este idioma: hay que recargar la página.',
  'Enter VR': 'Entrar en RV',
  'Enter AR': 'Entrar en RA',
  Models: 'Modelos',
  Cancel: 'Cancelar',
  Close: 'Cerrar',
  Scene: 'Escena',
  Remove: 'Quitar',
  Address: 'Dirección',
  Viewer: 'Visor',
  Lab: 'Lab',
  'Gallery of examples': 'Galería de ejemplos',
  None: 'Ninguno',
  Time: 'Tiempo',
  Particles: 'Partículas',
  Motion: 'Movimiento',
  Planes: 'Planos',
  Quality: 'Calidad',
  Full: 'Completa',
  Lite: 'Ligera',
  'Occlusion radius': 'Radio de la oclusión',
  'Distance within which surfaces darken a corner.': 'A qué distancia las cosas cierran un rincón.',
  'Occlusion strength': 'Fuerza de la oclusión',
  'How dark corners become; 1 is as computed.': 'Cuánto se oscurecen los rincones; 1 es lo calculado.',
  'Share of light that is lost on a metre, for small values.':
    'Parte de la luz que se pierde en un metro, si es pequeña.',
  'Fog anisotropy': 'Anisotropía de la niebla',
  'Above 0 fog scatters light forwards, and lamps have halos; below 0 backwards.':
    'Por encima de 0 la luz sigue adelante y las lámparas tienen halo; por debajo de 0 vuelve atrás.',
  'Fog height': 'Altura de la niebla',
  'Height up to which the fog has its density.': 'Altura hasta la que la niebla tiene su densidad.',
  'Fog falloff': 'Descenso de la niebla',
  'Rise above the height over which density falls to about a third; 0: it does not fall.':
    'Subida sobre la altura en la que la densidad cae a un tercio aproximadamente; 0: no cae.',
  'Fog noise': 'Ruido de la niebla',
  'How much drifting clouds vary the density.': 'Cuánto varían la densidad las nubes a la deriva.',
  'Fog noise size': 'Tamaño del ruido de la niebla',
  'Size of the clouds.': 'Tamaño de las nubes.',
  'Fog distance': 'Distancia de la niebla',
  'Distance at which fog ends; the nearer, the finer.': 'Distancia a la que acaba la niebla; cuanto menor, más fina.',
  Picture: 'Imagen',
  'Frame budget': 'Presupuesto por fotograma',
  'On touch screens': 'En pantallas táctiles',
  On: 'Activado',
  'Off ## budget': 'Desactivado',
  SMAA: 'SMAA',
  'Multisampled edges': 'Bordes con multimuestreo',
  TAA: 'TAA',
  'Frames a second': 'Fotogramas por segundo',
  Phong: 'Phong',
  Gouraud: 'Gouraud',
  Flat: 'Plano',
  Compare: 'Comparar',
  'Ambient occlusion': 'Oclusión ambiental',
  'Indirect light reaches less into corners; "Automatic" then takes a technique with a G-buffer.':
    'La luz indirecta llega menos a los rincones; «Automático» elige entonces una técnica con G-buffer.',
  'Unsorted transparency': 'Transparencia sin ordenar',
  'Transparent layers are averaged, not sorted: they may pass through one another.':
    'Las capas transparentes se promedian, sin ordenarlas: pueden atravesarse.',
  'Volumetric fog': 'Niebla volumétrica',
  'Fog that all lights light, with their shadows: halos, beams and shafts.':
    'Niebla que iluminan todas las luces, con sus sombras: halos, haces y rayos.',
  'Anti-aliasing': 'Antialiasing',
  Lights: 'Luces',
  Triangles: 'Triángulos',
  Programs: 'Programas',
  Targets: 'Destinos',
  'Picks the fastest technique for what is in view, and says why.':
    'Elige la técnica más rápida para lo que está a la vista; las cifras dicen cuál y por qué.',
  'An additive pass for each light over the objects it reaches.':
    'Luz ambiente y emisión una vez; después, una pasada aditiva por cada luz sobre los objetos que alcanza.',
  'Each object once, by a loop over all lights.': 'Cada objeto una vez; su shader recorre todas las luces.',
  'Surfaces into a G-buffer, then each light over the pixels of its volume.':
    'Las superficies a un G-buffer una vez; después, cada luz sobre los píxeles de su volumen.',
  'Normals, then the lights into a buffer, then the materials, lit by that buffer.':
    'Primero las normales, después las luces a un búfer y al final los materiales, iluminados por ese búfer.',
  'Light pre-pass at half the resolution, joined by a filter that keeps edges.':
    'Light pre-pass con los búferes a media resolución, unidos por un filtro que respeta los bordes.',
  'A light list for each tile, within its depths, over a G-buffer.':
    'Una lista de luces por tile, entre sus profundidades, sobre un G-buffer.',
  'A light list for each tile, walked by the materials.':
    'Una lista de luces por tile, que recorren los propios materiales.',
  'Depth, then a light list for each tile, within its depths, walked by the materials.':
    'Primero la profundidad; después, listas de luces entre las profundidades de cada tile, que recorren los materiales.',
  'Light lists by tile and depth, over a G-buffer.': 'Listas de luces por tile y profundidad, sobre un G-buffer.',
  'Light lists by tile and depth, walked by the materials.':
    'Listas de luces por tile y profundidad, que recorren los propios materiales.',
  Final: 'Final',
  Albedo: 'Albedo',
  Normal: 'Normales',
  Depth: 'Profundidad',
  Lighting: 'Iluminación',
  'Light count': 'Número de luces',
  Overdraw: 'Sobredibujado',
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
  'very many lights over a pixel: each surface is lit once, by the list of its tile':
    'muchísimas luces, muchas por píxel: cada superficie se ilumina una vez, con la lista de su tile, hecha en la GPU',
  'surfaces hide one another: depth is drawn first, so that each pixel is shaded once':
    'unas superficies tapan a otras: primero se dibuja la profundidad, y cada píxel se ilumina una sola vez',
  'few lights: lists cost more than they save': 'casi ninguna luz: las listas costarían más de lo que ahorran',
  Shadows: 'Sombras',
  'A temple of columns on a green plane, with moving lights.':
    'Un templo de columnas sobre un plano verde, con luces en movimiento.',
  'An atrium with two storeys of arcades, of the scale of the Sponza palace.':
    'Un atrio con dos pisos de arcadas, a la escala del palacio de Sponza.',
  'A dragon, a sphere and a cylinder in a room with all three kinds of lights.':
    'Un dragón, una esfera y un cilindro en una habitación con las tres clases de luces.',
  'Four dragons among coloured lights.': 'Cuatro dragones entre luces de colores.',
  'N × N planes with M × M moving lights above them, or grids that are no squares.':
    'N × N planos con M × M luces en movimiento encima, o cuadrículas que no son cuadradas.',
  'N × N meshes with M × M moving lights above them, or grids that are no squares.':
    'N × N mallas con M × M luces en movimiento encima, o cuadrículas que no son cuadradas.',
  Value: 'Valor',
};
