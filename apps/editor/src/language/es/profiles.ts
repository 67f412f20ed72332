import type { Texts } from '@farol/editing';

/** Spanish texts of photometric profiles and shading models. */
export const profiles: Texts = {
  'No profile': 'Sin perfil',
  'Light profile': 'Perfil de luz',
  'Light profiles': 'Perfiles de luz',
  Profile: 'Perfil',
  'Photometric file of a luminaire: how much light it gives in which direction.':
    'Archivo fotométrico de una luminaria: cuánta luz da en cada dirección.',
  'Brightness of the file': 'Brillo del archivo',
  'Shine as brightly as the file says: the intensity is then a factor, 1 for that of the file.':
    'Brilla tanto como dice el archivo: la intensidad es entonces un factor, 1 para la del archivo.',
  'Largest intensity {candelas} cd, luminous flux {lumens} lm':
    'Intensidad máxima {candelas} cd, flujo luminoso {lumens} lm',
  'Phong: normals are interpolated. Gouraud: light is evaluated at the vertices. Flat: one normal for each triangle.':
    'Phong: las normales se interpolan. Gouraud: la luz se evalúa en los vértices. Plano: una normal por triángulo.',
  'Shading models': 'Modelos de sombreado',
  'Flat, Gouraud and Phong side by side. Move the lamp, and choose another in the field “Shading” of a ball.':
    'Plano, Gouraud y Phong, uno junto a otro. Al mover la lámpara se ven las diferencias; el campo «Sombreado» de cada bola elige otro.',
  'Profiles of lights that are not loaded are left out': 'Se omiten los perfiles de las luces que no se han cargado',
  'Cones of lights with a profile are left out': 'Se omiten los conos de las luces con perfil',
  'Lights with a profile have an end in Farol alone; elsewhere they go on':
    'Las luces con perfil terminan solo en Farol; en otros programas siguen',
  'Particles and the light that they give are left out': 'Se omiten las partículas y la luz que dan',
  'Lights that fade in a way of their own do so in Farol alone; elsewhere they fade as in nature, as bright half way':
    'Las luces que se atenúan a su manera lo hacen solo en Farol; en otros programas se atenúan como en la naturaleza, con el mismo brillo a medio camino',
  'Spot lights with an exponent keep it in Farol alone; elsewhere they have an edge':
    'Las luces focales con exponente lo conservan solo en Farol; en otros programas tienen un borde',
  'Second colours of lights are kept in Farol alone': 'Los segundos colores de las luces se conservan solo en Farol',
  'Polar curve of {name}': 'Curva polar de {name}',
};
