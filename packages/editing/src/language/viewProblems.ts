import type { Texts } from './translate';

/** Spanish sentences on what a frame lacks for a view, by the renderer's English ones. */
export const viewProblems: Texts = {
  'Ambient occlusion is not in this frame: switch it on, with a technique that knows depth before it shades, such as Deferred shading, Light pre-pass or Forward+.':
    'En este fotograma no hay oclusión ambiental: se activa, con una técnica que conozca la profundidad antes de sombrear, como Sombreado diferido, Light pre-pass o Forward+.',
  'Motion is not in this frame: switch on the anti-aliasing TAA.':
    'En este fotograma no hay movimiento: hay que activar el antialiasing TAA.',
  'The reactive mask is not in this frame: switch on the anti-aliasing TAA.':
    'En este fotograma no hay máscara reactiva: hay que activar el antialiasing TAA.',
  'The reactive mask is empty: it holds particles, and none is in view.':
    'La máscara reactiva está vacía: contiene partículas, y no hay ninguna a la vista.',
  'The light buffer is not in this frame: choose the technique Light pre-pass or Inferred lighting.':
    'En este fotograma no hay búfer de luz: hay que elegir la técnica Light pre-pass o Iluminación inferida.',
  'No shadow map is in this frame: let a light that is in view cast shadows.':
    'En este fotograma no hay mapas de sombra: hay que hacer que proyecte sombras una luz que esté a la vista.',
  'No profile or image of a light lies in the atlas: give a light that is in view a photometric profile.':
    'En el atlas no hay perfiles ni imágenes de luces: hay que dar un perfil fotométrico a una luz que esté a la vista.',
  'Volumetric fog is not in this frame: switch it on, and look with a camera that has perspective.':
    'En este fotograma no hay niebla volumétrica: se activa, y se mira con una cámara en perspectiva.',
};
