import { createRandom } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { addClip, eased, track } from './clips';
import { light, marble, mesh, stone, wood } from './parts';
import { addDoor } from './night/addDoor';
import { lanternPrefab } from './night/lanternPrefab';
import { addPlayer } from './night/addPlayer';
import { type Overrides, type ReadPublic, SampleScene } from './SampleScene';

const sources: Readonly<Record<string, string>> = import.meta.glob('./night/scripts/*.ts', {
  eager: true,
  query: '?raw',
  import: 'default',
});

/** Heights of the temple's floor, and of the undersides of its beams (m), from the engine's `templePlan`. */
const FLOOR = 0.96;
const BEAMS = 7.16;
/** Centres of the gaps between the front columns (x, m). */
const GAPS = [-5.4, -2.7, 2.7, 5.4] as const;

function addGround(scene: SampleScene): void {
  const grass = {
    map: 'grass',
    normalMap: 'grass-normal',
    colour: [0.34, 0.36, 0.32],
    repeat: 45,
    roughness: 0.95,
  } as const;
  scene.object('Ground', { scale: [120, 1, 120] }, mesh('plane', grass), [
    'Collider',
    { fit: false, offset: [0, -0.5, 0] },
  ]);
  const path = scene.object('Path', {});
  const slab = { ...stone, repeat: 1, colour: [0.62, 0.6, 0.56] } as const;
  const random = createRandom(5);
  for (let i = 0; i < 11; i++) {
    for (const side of [-0.72, 0.72]) {
      const place = {
        position: [side + 0.1 * (random() - 0.5), 0.005, 13.4 + i * 1.25] as const,
        rotation: [0, 0.08 * (random() - 0.5), 0] as const,
        scale: [1.32, 0.05, 1.12] as const,
        parent: path,
      };
      scene.object('Slab', place, mesh('box', slab));
    }
  }
}

/** The engine's temple, with colliders. */
function addTemple(scene: SampleScene): string {
  const temple = scene.object('Temple', {});
  const stones = { ...marble, repeat: 0.5 } as const;
  scene.object('Steps', { parent: temple }, mesh('temple/steps', stones), ['Collider', { shape: 'mesh' }]);
  const column = scene.prefab('Column', () =>
    scene.object('Column', {}, mesh('temple/column', stones), ['Collider', { shape: 'cylinder' }]),
  );
  const columns = scene.object('Columns', { parent: temple });
  for (let i = 0; i < 6; i++) {
    for (let j = 0; j < 9; j++) {
      if (i > 0 && i < 5 && j > 0 && j < 8) continue;
      scene.instance(column, { position: [i * 2.7 - 6.75, FLOOR, j * 2.7 - 10.8], parent: columns });
    }
  }
  scene.object('Entablature', { position: [0, BEAMS, 0], parent: temple }, mesh('temple/entablature', stones));
  const roof = { ...marble, colour: [0.5, 0.33, 0.26], repeat: 0.5 } as const;
  scene.object('Roof', { position: [0, BEAMS + 1.75, 0], parent: temple }, mesh('temple/roof', roof));
  const walls = { ...stone, repeat: 0.25 } as const;
  scene.object('Cella', { position: [0, FLOOR, 0], parent: temple }, mesh('temple/cella', walls), [
    'Collider',
    { shape: 'mesh' },
  ]);
  return temple;
}

/** An altar with a flickering fire, in the inner room. */
function addAltar(scene: SampleScene, temple: string): void {
  const altar = scene.object('Altar', { position: [0, FLOOR, -4.2], parent: temple });
  const blocks = [
    [3.4, 0.3, 2.2, 0.15],
    [2.6, 0.3, 1.6, 0.45],
    [1.5, 0.9, 0.9, 1.05],
  ] as const;
  for (const [x, y, z, height] of blocks) {
    const place = { position: [0, height, 0], scale: [x, y, z], parent: altar } as const;
    scene.object('Block', place, mesh('box', { ...marble, repeat: 0.6 }), ['Collider']);
  }
  const bronze = { colour: [0.36, 0.22, 0.1], roughness: 0.35, metalness: 0.9 } as const;
  scene.object('Bowl', { position: [0, 1.6, 0], scale: [0.9, 0.22, 0.9], parent: altar }, mesh('cylinder', bronze));
  const flame = { colour: [0.1, 0.03, 0.01], emissive: [1, 0.36, 0.07], emissiveIntensity: 5 } as const;
  const flicker = eased(
    [0, 46],
    [0.13, 38],
    [0.27, 52],
    [0.4, 41],
    [0.62, 55],
    [0.8, 43],
    [1, 50],
    [1.3, 37],
    [1.5, 46],
  );
  const clip = addClip(scene, 'Fire flickers', 1.5, [
    track('Firelight', 'Light.intensity', flicker),
    track(
      'Flame',
      'Transform.scale',
      eased([0, [0.3, 0.62, 0.3]], [0.35, [0.34, 0.72, 0.32]], [0.9, [0.28, 0.56, 0.3]], [1.5, [0.3, 0.62, 0.3]]),
    ),
  ]);
  const fire = scene.object('Fire', { position: [0, 1.75, 0], parent: altar }, ['Animation', { clip }]);
  for (const [x, z, size] of [
    [0, 0, 1],
    [0.17, 0.08, 0.65],
    [-0.15, 0.1, 0.55],
    [0.02, -0.16, 0.7],
  ] as const) {
    const place = {
      position: [x, size * 0.22, z],
      scale: [0.3 * size, 0.62 * size, 0.3 * size],
      parent: fire,
    } as const;
    scene.object('Flame', place, ['ObjectRenderer', { mesh: 'cone', ...flame }]);
  }
  scene.object('Firelight', { position: [0, 0.9, 0], parent: fire }, [
    'Light',
    { diffuse: [1, 0.5, 0.18], intensity: 46, range: 13, castShadow: true, shadowMapSize: 512, shadowRadius: 3 },
  ]);
  for (const x of [-2.9, 2.9]) {
    const bowl = { position: [x, FLOOR + 0.5, -5.4], parent: temple } as const;
    const brazier = scene.object('Brazier', bowl);
    scene.object('Foot', { scale: [0.34, 1, 0.34], parent: brazier }, mesh('cylinder', bronze), [
      'Collider',
      { shape: 'cylinder' },
    ]);
    const coals = { position: [0, 0.55, 0], scale: [0.6, 0.16, 0.6], parent: brazier } as const;
    scene.object(
      'Coals',
      coals,
      mesh('cylinder', { colour: [0.05, 0.03, 0.03], emissive: [1, 0.2, 0.03], emissiveIntensity: 3 }),
    );
    scene.object('Glow', { position: [0, 0.9, 0], parent: brazier }, [
      'Light',
      { diffuse: [1, 0.4, 0.14], intensity: 9, range: 6 },
    ]);
  }
}

/** Lanterns between the columns; four at the front cast shadows. */
function addLanterns(scene: SampleScene): void {
  const lantern = lanternPrefab(scene);
  const lanterns = scene.object('Lanterns', {});
  // random pushes, so that no two swing alike
  const random = createRandom(3);
  const push = (): Overrides => ({
    'Body/RigidBody.initialVelocity': [1.5 * (random() - 0.5), 0, 1.1 * (random() - 0.5)],
  });
  for (const [i, x] of GAPS.entries()) {
    const place = { position: [x, BEAMS, 10.8], rotation: [0, i * 0.5, 0], parent: lanterns } as const;
    scene.instance(lantern, place, { 'Flame/Light.castShadow': true, ...push() });
  }
  for (const z of [5.4, 0, -5.4]) {
    for (const x of [-6.75, 6.75]) {
      scene.instance(lantern, { position: [x, BEAMS, z + 1.35], parent: lanterns }, push());
    }
  }
}

const insects: readonly Vector3Tuple[] = [
  [0.75, 1, 0.25],
  [0.95, 0.9, 0.3],
  [0.5, 1, 0.4],
];

/** Fireflies: many small lights that move over the grass and among the columns. */
function addFireflies(scene: SampleScene, count: number): void {
  const random = createRandom(11);
  const fireflies = scene.object('Fireflies', {});
  for (let i = 0; i < count; i++) {
    const diffuse = insects[i % insects.length];
    const angle = random() * 2 * Math.PI;
    // most of them are in front of the temple
    const front = random() < 0.6;
    const position: Vector3Tuple = front
      ? [22 * (random() - 0.5), 0.35 + 1.5 * random() ** 2, 12.5 + 13 * random()]
      : [Math.cos(angle) * (9 + 4 * random()), 0.4 + 2.2 * random(), Math.sin(angle) * (12 + 4 * random())];
    scene.object(
      'Firefly',
      { position, scale: [0.35, 0.35, 0.35], parent: fireflies },
      ['Light', { diffuse, intensity: 0.4, range: 2.4 }],
      ['ObjectRenderer', { mesh: 'bulb', kind: 'basic', colour: diffuse, instanced: true }],
      ['RandomMovement', { seed: 1000 + i, extent: [1.8, 0.5, 1.8], speed: 0.45 + 0.4 * random() }],
    );
  }
}

/** Crates in front of the steps, and urns at the door, which fall when the player walks into them. */
function addThings(scene: SampleScene, thud: string): void {
  const crate = scene.prefab('Crate', () => {
    const box = { ...wood, repeat: 1 } as const;
    const root = scene.object(
      'Crate',
      {},
      mesh('box', box),
      ['Collider', { friction: 0.6 }],
      ['RigidBody', { mass: 14 }],
      ['AudioSource', { sound: thud, playOnStart: false, volume: 0.8 }],
      ['Thud', { impulse: 14 }],
    );
    for (const x of [-0.47, 0.47]) {
      for (const z of [-0.47, 0.47]) {
        const place = { position: [x, 0, z], scale: [0.1, 1.02, 0.1], parent: root } as const;
        scene.object('Edge', place, mesh('box', { ...box, colour: [0.5, 0.38, 0.26] }));
      }
    }
    return root;
  });
  const pile = scene.object('Crates', { position: [4.4, 0, 14.9], rotation: [0, 0.35, 0] });
  const places: readonly Vector3Tuple[] = [
    [0, 0.36, 0],
    [0.82, 0.36, 0.1],
    [1.62, 0.36, -0.08],
    [0.4, 1.08, 0.05],
    [1.24, 1.08, 0.02],
    [0.8, 1.8, 0],
  ];
  for (const [i, position] of places.entries()) {
    const place = {
      position,
      rotation: [0, [0.06, -0.1, 0.04, 0.2, -0.12, 0.3][i], 0],
      scale: [0.72, 0.72, 0.72],
    } as const;
    scene.instance(crate, { ...place, parent: pile });
  }
  const urn = scene.prefab('Urn', () =>
    scene.object(
      'Urn',
      {},
      mesh('sponza/urn', { ...marble, colour: [0.56, 0.3, 0.19], repeat: 1, roughness: 0.8 }),
      ['Collider', { shape: 'hull', friction: 0.7 }],
      ['RigidBody', { mass: 6 }],
      ['AudioSource', { sound: thud, playOnStart: false, volume: 0.6, playbackRate: 1.5 }],
      ['Thud', { impulse: 6 }],
    ),
  );
  const urns = scene.object('Urns', {});
  for (const [x, z] of [
    [-2.35, 7.35],
    [2.35, 7.35],
    [-2.2, -2.6],
    [2.2, -2.6],
  ] as const) {
    scene.instance(urn, { position: [x, FLOOR, z], parent: urns });
  }
}

function addTrees(scene: SampleScene): void {
  const cypress = scene.prefab('Cypress', () => {
    const tree = scene.object('Cypress', {});
    const leaf = { colour: [0.05, 0.12, 0.07], roughness: 0.9 } as const;
    const bark = { colour: [0.14, 0.1, 0.07], roughness: 0.95 } as const;
    scene.object('Trunk', { position: [0, 0.5, 0], scale: [0.3, 1, 0.3], parent: tree }, mesh('cylinder', bark));
    scene.object('Leaves', { position: [0, 4.4, 0], scale: [1.7, 7.6, 1.7], parent: tree }, mesh('sphere', leaf));
    return tree;
  });
  const random = createRandom(23);
  const trees = scene.object('Trees', {});
  for (let i = 0; i < 22; i++) {
    const side = i % 2 === 0 ? -1 : 1;
    const size = 0.7 + 0.6 * random();
    const position: Vector3Tuple = [side * (11.5 + 9 * random()), 0, 24 - i * 2.4 + 2 * random()];
    scene.instance(cypress, { position, scale: [size, size * (0.9 + 0.4 * random()), size], parent: trees });
  }
}

/**
 * A walk by night: swinging lanterns with shadows, fireflies, a door that opens when one comes near, and crates and
 * urns that fall when pushed.
 */
export async function nightInTheTemple(readPublic: ReadPublic): Promise<SampleScene> {
  const scene = new SampleScene('Night in the temple');
  Object.assign(scene.settings, {
    ...{ background: 'sky', sky: 'night', environmentIntensity: 1, backgroundIntensity: 1.2 },
    ...{ fog: 'exponential', fogFromSky: true, fogDensity: 0.012 },
    ...{ toneMapping: 'aces-filmic', exposure: 1.25, shadowCascades: 2 },
    ...{ bloom: true, bloomIntensity: 0.7, bloomThreshold: 1.1, vignette: true, vignetteDarkness: 0.45 },
  });
  for (const [path, source] of Object.entries(sources))
    scene.asset('script', path.replace('./night/scripts/', '').replace(/\.ts$/, ''), { source });
  const [step, creak, thud, crickets] = await Promise.all(
    ['step', 'doorCreak', 'thud', 'crickets'].map(async (name) =>
      scene.file('sound', `Sounds/${name}.wav`, await readPublic(`sounds/${name}.wav`)),
    ),
  );
  for (const x of [-11, 11]) {
    scene.object('Crickets', { position: [x, 0.5, 17] }, [
      'AudioSource',
      {
        sound: crickets,
        loop: true,
        volume: 0.35,
        maxDistance: 45,
        referenceDistance: 4,
        playbackRate: x < 0 ? 1 : 0.93,
      },
    ]);
  }
  scene.object(
    'Moon',
    { position: [-16, 20, 22], target: [0, 0, 2] },
    light('directional', { diffuse: [0.52, 0.64, 1], intensity: 0.5, shadowExtent: 22 }),
  );
  addGround(scene);
  const temple = addTemple(scene);
  addDoor(scene, FLOOR, creak);
  addAltar(scene, temple);
  addLanterns(scene);
  addThings(scene, thud);
  addTrees(scene);
  addFireflies(scene, 110);
  addPlayer(scene, step);
  return scene;
}
