import type { Texts } from '@farol/editing';

/** Spanish of texts that the editor has too, in its words. */
export const shared: Texts = {
  Time: 'Tiempo',
  Linear: 'Lineal',
  Colours: 'Colores',
  Programs: 'Programas',
  Technique: 'Técnica',
  Lights: 'Luces',
  Compare: 'Comparar',
  Rename: 'Renombrar',
  Delete: 'Eliminar',
  Undo: 'Deshacer',
  'Frames a second': 'Fotogramas por segundo',
  Scene: 'Escena',
  Language: 'Idioma',
  Cancel: 'Cancelar',
  Theme: 'Tema',
  None: 'Ninguno',
  Remove: 'Quitar',
  Shading: 'Sombreado',
  Width: 'Ancho',
  Height: 'Alto',
  Close: 'Cerrar',
  Name: 'Nombre',
  Show: 'Mostrar',
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
  Resolution: 'Resolución',
  Overdraw: 'Sobredibujado',
  Shadows: 'Sombras',
  Planes: 'Planos',
  Temple: 'Templo',
  Particles: 'Partículas',
  Flat: 'Plano',
  Gouraud: 'Gouraud',
  Phong: 'Phong',
  Frame: 'Fotograma',
  Value: 'Valor',
  Picture: 'Imagen',
  Draws: 'Llamadas de dibujo',
  Triangles: 'Triángulos',
  Targets: 'Destinos',
};
