/** Spanish texts of the tool that lists how much each light adds to a pixel. */
export const pixelLighting = {
  'Explain a pixel': 'Explicar un píxel',
  'Explain the middle': 'Explicar el centro',
  'Click the picture: the lights that make the pixel are listed, brightest first.':
    'Con un clic en la imagen se listan las luces que forman el píxel, la más brillante primero.',
  'Lights are drawn one by one': 'Las luces se dibujan una por una',
  'Linear RGB, before exposure and tone mapping': 'RGB lineal, antes de la exposición y el mapeo de tonos',
  Share: 'Parte',
  'Share of all light that reaches the pixel': 'Parte de toda la luz que llega al píxel',
  Unshadowed: 'Sin sombra',
  'What the share would be if nothing cast a shadow in this light':
    'La parte que tendría si nada proyectara sombra en esta luz',
  'Estimated share of the lighting time of the picture': 'Parte estimada del tiempo de iluminación de la imagen',
  'No light reaches this pixel.': 'Ninguna luz llega a este píxel.',
  'Without effects that need the whole picture: {names}': 'Sin efectos de la imagen entera: {names}',
  'The picture changed meanwhile: the shares are of different times.':
    'La imagen cambió mientras tanto: las partes son de varios momentos.',
  'Microshaders that ran': 'Microshaders que se ejecutaron',
  'Its own material': 'Su propio material',
  Lightmap: 'Mapa de luz',
  'Light probe': 'Sonda de luz',
  'Baked light probes': 'Sondas de luz horneadas',
  'Background and unlit': 'Fondo y sin iluminar',
  '{count} weaker lights': '{count} luces más débiles',
};
