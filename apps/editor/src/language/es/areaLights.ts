import type { Texts } from '@farol/editing';

/** Spanish texts of area lights. */
export const areaLights: Texts = {
  'Rectangle light': 'Luz rectangular',
  'Disc light': 'Luz de disco',
  'Tube light': 'Luz de tubo',
  Length: 'Longitud',
  'Sized {name}': 'Cambiar el tamaño de {name}',
  rectangle: 'rectángulo',
  disc: 'disco',
  tube: 'tubo',
  'Ambient, hemisphere, directional, point or spot light, or one that shines from a rectangle, a disc or a tube.':
    'Luz ambiente, hemisférica, direccional, puntual o focal, o una que brilla desde un rectángulo, un disco o un tubo.',
  'cd or lx or nt': 'cd o lx o nt',
  'Candela for point and spot lights, nits (cd/m²) for rectangles, discs and tubes, lux for the others; multiplies every colour of the light.':
    'Candelas en luces puntuales y focales, nits (cd/m²) en rectángulos, discos y tubos, lux en las demás; multiplica todos los colores de la luz.',
  'Width of the shape that shines; of a tube: its length.': 'Anchura de la forma que brilla; de un tubo, su longitud.',
  'Height of the shape that shines; of a tube: how thick it is.':
    'Altura de la forma que brilla; de un tubo, su grosor.',
  'Distance from the shape where the light ends, fading from half of it on; 0: where it gives next to nothing.':
    'Distancia a la forma donde la luz acaba, desvaneciéndose desde la mitad; 0: donde ya casi no da nada.',
  'Lights with a shape shine in Farol alone: glTF has none':
    'Las luces con forma solo brillan en Farol: glTF no las tiene',
};
