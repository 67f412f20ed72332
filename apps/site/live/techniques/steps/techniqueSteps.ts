import type { TechniqueName, View } from '@farol/renderer';

/** A text in English and in Spanish. */
type Text = readonly [english: string, spanish: string];

/** One step of a technique, as a picture. */
export interface Step {
  readonly view: View;
  readonly name: Text;
  readonly help: Text;
  /** Lights of the scene that shine; default all. */
  readonly lights?: number;
}

const albedo: Step = {
  view: 'albedo',
  name: ['Albedo', 'Albedo'],
  help: [
    'Surfaces are drawn once. Their colour goes into the first texture.',
    'Las superficies se dibujan una vez. Su color va a la primera textura.',
  ],
};
const normal: Step = {
  view: 'normal',
  name: ['Normals', 'Normales'],
  help: [
    'In the same draw: the direction that each pixel faces.',
    'En el mismo dibujo: la dirección a la que mira cada píxel.',
  ],
};
const roughness: Step = {
  view: 'roughness',
  name: ['Roughness', 'Rugosidad'],
  help: [
    'And how rough it is; metalness and emitted light lie beside it.',
    'Y su rugosidad; junto a ella, metalicidad y luz emitida.',
  ],
};
const depth: Step = {
  view: 'depth',
  name: ['Depth', 'Profundidad'],
  help: [
    'Depth tells where the surface of a pixel is: near is dark.',
    'La profundidad dice dónde está la superficie de un píxel: cerca es oscuro.',
  ],
};
const depthFirst: Step = {
  ...depth,
  help: [
    'Depth is drawn first, without light: what is hidden is not shaded later.',
    'Primero se dibuja la profundidad, sin luz: lo oculto no se sombrea después.',
  ],
};
const position: Step = {
  view: 'position',
  name: ['Positions', 'Posiciones'],
  help: [
    'Positions are not stored: they are rebuilt from depth.',
    'Las posiciones no se guardan: se reconstruyen a partir de la profundidad.',
  ],
};
const count = (help: Text): Step => ({ view: 'light-count', name: ['Lights a pixel', 'Luces por píxel'], help });
const lighting = (help: Text): Step => ({ view: 'lighting', name: ['Light', 'Luz'], help });
const final = (help: Text): Step => ({ view: 'final', name: ['Picture', 'Imagen'], help });
const overdraw: Step = {
  view: 'overdraw',
  name: ['Draws a pixel', 'Dibujos por píxel'],
  help: [
    'How many surfaces were shaded in each pixel: all but the last in vain.',
    'Cuántas superficies se sombrearon en cada píxel: todas menos la última, en vano.',
  ],
};

const tiles: Text = [
  'The screen is cut into tiles. Each tile lists the lights whose range reaches into it, at any depth.',
  'La pantalla se corta en tiles. Cada tile lista las luces cuyo alcance entra en él, a cualquier profundidad.',
];
const tilesInDepth: Text = [
  'Each tile lists the lights that reach into it between the nearest and the farthest surface in it.',
  'Cada tile lista las luces que entran en él entre su superficie más cercana y la más lejana.',
];
const clusters: Text = [
  'Each tile is cut by depth, too. A pixel walks the lights of its cluster alone.',
  'Cada tile se corta también en profundidad. Un píxel recorre solo las luces de su cluster.',
];
const volumes: Text = [
  'Each light is drawn as a ball of its range, and looks only at the pixels that the ball covers.',
  'Cada luz se dibuja como una esfera de su alcance, y mira solo los píxeles que la esfera cubre.',
];
const materials: Text = [
  'The materials walk the lists while they are drawn, as three draws them. Glass uses the same lists.',
  'Los materiales recorren las listas al dibujarse, como los dibuja three. El vidrio usa las mismas listas.',
];
const once: Text = [
  'Each pixel adds its lights up once, then fog and tone mapping.',
  'Cada píxel suma sus luces una vez; luego niebla y mapeo de tonos.',
];
const gbuffer = [albedo, normal, roughness, depth];

const added = (lights: number): Step => ({
  view: 'final',
  lights,
  name: [`${lights} lights`, `${lights} luces`],
  help: [
    'Each light is a pass of its own over the objects that it reaches, added to what is there.',
    'Cada luz es una pasada propia sobre los objetos que alcanza, sumada a lo que hay.',
  ],
});

/** Steps of techniques, in the order of their passes. */
const techniqueSteps: Readonly<Partial<Record<TechniqueName, readonly Step[]>>> = {
  forward: [
    {
      ...added(0),
      name: ['Ambient', 'Ambiente'],
      help: [
        'First each object once, with ambient and emitted light.',
        'Primero cada objeto una vez, con la luz ambiente y la emitida.',
      ],
    },
    added(1),
    added(2),
    added(8),
    final([
      'All lights: objects times the lights that reach them are drawn.',
      'Todas las luces: se dibujan los objetos por las luces que los alcanzan.',
    ]),
  ],
  'forward-single-pass': [
    overdraw,
    count([
      'Each pixel walks all lights of the scene, near or far.',
      'Cada píxel recorre todas las luces de la escena, cerca o lejos.',
    ]),
    final(['One draw an object, one loop over all lights.', 'Un dibujo por objeto, un bucle sobre todas las luces.']),
  ],
  deferred: [
    ...gbuffer,
    position,
    count(volumes),
    lighting(['What they give is added up in a buffer.', 'Lo que dan se suma en un búfer.']),
    final(once),
  ],
  'light-prepass': [
    {
      ...normal,
      help: ['Normals and shininess are drawn first, nothing else.', 'Primero se dibujan normales y brillo, nada más.'],
    },
    depth,
    lighting([
      'Lights are added up in a buffer that knows no colour of surfaces yet.',
      'Las luces se suman en un búfer que aún no conoce el color de las superficies.',
    ]),
    final([
      'The objects are drawn again by their own materials, lit by that buffer.',
      'Los objetos se dibujan otra vez con sus materiales, iluminados por ese búfer.',
    ]),
  ],
  inferred: [
    {
      ...normal,
      help: [
        'Normals at half the resolution, with the number of each object.',
        'Normales a media resolución, con el número de cada objeto.',
      ],
    },
    lighting([
      'Light is added up at half the resolution, too: a quarter of the pixels.',
      'La luz también se suma a media resolución: un cuarto de los píxeles.',
    ]),
    final([
      'Materials at full resolution take light only from texels of the same object.',
      'Los materiales, a resolución completa, toman luz solo de texels del mismo objeto.',
    ]),
  ],
  'tiled-forward': [count(tiles), overdraw, final(materials)],
  'tiled-deferred': [...gbuffer, count(tilesInDepth), final(once)],
  'forward-plus': [depthFirst, count(tilesInDepth), final(materials)],
  'clustered-forward': [count(clusters), overdraw, final(materials)],
  'clustered-deferred': [...gbuffer, count(clusters), final(once)],
};

/** Steps of a technique; one that has none here shows its picture alone. */
export const stepsOf = (technique: TechniqueName): readonly Step[] =>
  techniqueSteps[technique] ?? [final(['All that the technique draws.', 'Todo lo que dibuja la técnica.'])];
