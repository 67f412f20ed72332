import type { Texts } from '@farol/editing';

/** Samples and their shadows, in Spanish. */
export const samples: Texts = {
  Shadows: 'Sombras',
  'How the shadows of all lights are drawn.': 'Cómo se dibujan las sombras de todas las luces.',
  'How shadows are drawn. Variance blurs them widely, but not those of point lights, and light may leak through.':
    'Cómo se dibujan las sombras. La varianza las difumina mucho, pero no las de luces puntuales, y puede filtrarse luz.',
  Hard: 'Duras',
  'Soft (PCF)': 'Suaves (PCF)',
  'Variance (VSM)': 'Varianza (VSM)',
  Softness: 'Suavidad',
  'Factor of the softness of every light’s shadows.': 'Factor de la suavidad de las sombras de todas las luces.',
  Cascades: 'Cascadas',
  'Shadow maps of each directional light: each one more is finer near the camera.':
    'Mapas de sombra de cada luz direccional: cada uno más es más fino cerca de la cámara.',
};
