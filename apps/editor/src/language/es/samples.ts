import type { Texts } from '@farol/editing';

/** Spanish texts of samples. */
export const samples: Texts = {
  'Fire and sparks': 'Fuego y chispas',
  'Every spark is a light. Select “Sparks” and watch; change its rate, its curves, and what it lights.':
    'Cada chispa es una luz. Selecciona «Sparks» y mira; cambia su tasa, sus curvas y lo que ilumina.',
  'How the shadows of all lights are drawn.': 'Cómo se dibujan las sombras de todas las luces.',
  'How shadows are drawn. Variance blurs them widely, but not those of point lights, and light may leak through.':
    'Cómo se dibujan las sombras. La varianza las difumina mucho, pero no las de luces puntuales, y puede filtrarse luz.',
  Hard: 'Duras',
  'Soft (PCF)': 'Suaves (PCF)',
  'Variance (VSM)': 'Varianza (VSM)',
  'Factor of the softness of every light’s shadows.': 'Factor de la suavidad de las sombras de todas las luces.',
  'Night in the temple': 'Noche en el templo',
  'Play, then walk up the steps. The door opens when you come near; push the crates.':
    'Reproduce y sube los escalones. La puerta se abre al acercarse; empuja las cajas.',
  'Foggy street': 'Calle con niebla',
  'Lamps, the moon and a car in fog. Play; then open Frame and change the density of “Volumetric fog”.':
    'Farolas, la luna y un coche en la niebla. Reproduce; luego abre Fotograma y cambia la densidad de «Niebla volumétrica».',
  'A fairground of clips. Open the Timeline, move keys of “Arm reaches”, and play.':
    'Una feria de clips. Abre la línea de tiempo, mueve claves de «Arm reaches» y reproduce.',
  'Play: a ball on a chain knocks down a wall. Change masses, joints and bounciness.':
    'Reproduce: una bola con cadena derriba un muro. Cambia masas, articulaciones y rebote.',
  'Play, then edit “Wave” in the Scripts panel: it changes while it runs. F stops the fountain.':
    'Reproduce y edita «Wave» en el panel Scripts: cambia mientras funciona. F detiene la fuente.',
  'A street of lamps and benches. Change one lamp, then “Apply all to prefab”.':
    'Una calle de farolas y bancos. Cambia una farola y luego «Aplicar todo al prefab».',
  'Light in bands and rings. Edit “lightAttenuation” in the Microshaders panel.':
    'Luz en bandas y anillos. Edita «lightAttenuation» en el panel Microshaders.',
  'The sample {file} could not be read: the server answered {status}.':
    'No se pudo leer el ejemplo {file}: el servidor respondió {status}.',
  Cascades: 'Cascadas',
  'Shadow maps of each directional light: each one more is finer near the camera.':
    'Mapas de sombra de cada luz direccional: cada uno más es más fino cerca de la cámara.',
};
