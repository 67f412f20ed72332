/** Spanish names of built-in textures and light profiles. */
export const assetNames = {
  Checker: 'Ajedrez',
  Marble: 'Mármol',
  Stone: 'Piedra',
  Brick: 'Ladrillo',
  Tiles: 'Baldosas',
  Plaster: 'Yeso',
  Wood: 'Madera',
  Grass: 'Hierba',
  'Cloth red': 'Tela roja',
  'Cloth green': 'Tela verde',
  'Cloth blue': 'Tela azul',
  Downlight: 'Foco empotrado',
  'Wall washer': 'Bañador de pared',
  'Street light': 'Farola',
};
