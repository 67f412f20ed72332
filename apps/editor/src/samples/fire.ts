import { createRandom } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { addClip, eased, track } from './clips';
import { addCamera, light, mesh, stone } from './parts';
import { type Part, SampleScene, type Values } from './SampleScene';

const emitter = (values: Values): Part => ['ParticleEmitter', values];

const bark = { colour: [0.17, 0.1, 0.06], normalMap: 'stone-normal', roughness: 0.95, repeat: 1 } as const;
const leaf = { colour: [0.05, 0.11, 0.06], roughness: 0.95 } as const;

/** Particles of flames: few large ones with lights, so that the light on the ground flickers. */
const flames: Values = {
  ...{ rate: 240, capacity: 600, prewarm: 2, shape: 'cone', radius: 0.26, angle: 0.1 },
  ...{ lifeFrom: 0.7, lifeTo: 1.5, speedFrom: 0.5, speedTo: 1.1, gravity: [0, 0.9, 0], drag: 0.6 },
  ...{ noiseStrength: 1.6, noiseFrequency: 1.4, noiseScroll: 1 },
  ...{ sizeFrom: 0.25, sizeTo: 0.5, spinFrom: -1.5, spinTo: 1.5, brightness: 0.9 },
  sizeOverLife: [
    [0, 0.45],
    [0.25, 1],
    [1, 0.12],
  ],
  colourOverLife: [
    [0, [0.25, 0.3, 0.9], 0],
    [0.08, [1, 0.5, 0.16], 0.55],
    [0.35, [1, 0.26, 0.045], 0.45],
    [0.75, [0.7, 0.06, 0.01], 0.22],
    [1, [0.2, 0.01, 0], 0],
  ],
  ...{ shine: true, lightEvery: 20, lightIntensity: 1.6, lightRange: 4.5 },
};

/** Particles of sparks, which rise, fall, bounce off the ground and light it. */
const sparks: Values = {
  ...{ rate: 26, burstCount: 70, burstTime: 0.2, duration: 2.4, capacity: 600, prewarm: 2, seed: 4 },
  ...{ shape: 'cone', radius: 0.16, angle: 0.55, lifeFrom: 0.9, lifeTo: 2.8, speedFrom: 1.6, speedTo: 4.6 },
  ...{ gravity: [0, -4.2, 0], drag: 0.4, noiseStrength: 2.4, noiseFrequency: 0.8, noiseScroll: 0.6 },
  ...{ collides: true, bounce: 0.45, friction: 0.3 },
  ...{ render: 'stretched', stretch: 0.03, sizeFrom: 0.012, sizeTo: 0.028, brightness: 7, softness: 0 },
  sizeOverLife: [
    [0, 1],
    [0.7, 0.8],
    [1, 0],
  ],
  colourOverLife: [
    [0, [1, 0.82, 0.45], 1],
    [0.4, [1, 0.42, 0.09], null],
    [1, [0.6, 0.08, 0.01], 0.8],
  ],
  ...{ shine: true, lightEvery: 1, lightIntensity: 0.16, lightRange: 1.1 },
};

const smoke: Values = {
  ...{ rate: 16, capacity: 160, prewarm: 7, seed: 2, shape: 'cone', radius: 0.2, angle: 0.16 },
  ...{ lifeFrom: 4, lifeTo: 7, speedFrom: 0.5, speedTo: 0.8, gravity: [0.06, 0.12, 0], drag: 0.22 },
  ...{ noiseStrength: 0.45, noiseFrequency: 0.6, noiseScroll: 0.4 },
  ...{ sizeFrom: 0.7, sizeTo: 1.1, spinFrom: -0.5, spinTo: 0.5, blending: 'blended', softness: 0.5 },
  ...{ lit: true, receiveShadow: true },
  sizeOverLife: [
    [0, 0.35],
    [0.4, 1.1],
    [1, 2.4],
  ],
  colourOverLife: [
    [0, [0.3, 0.29, 0.28], 0],
    [0.2, null, 0.11],
    [0.6, null, 0.07],
    [1, [0.42, 0.42, 0.44], 0],
  ],
};

const fireflies: Values = {
  ...{ rate: 22, capacity: 260, prewarm: 9, seed: 9, shape: 'box', boxSize: [16, 1.4, 10] },
  ...{ lifeFrom: 5, lifeTo: 9, speedFrom: -0.1, speedTo: 0.1, drag: 0.8 },
  ...{ noiseStrength: 0.7, noiseFrequency: 0.6, noiseScroll: 0.25 },
  ...{ sizeFrom: 0.03, sizeTo: 0.055, brightness: 5, softness: 0 },
  colourOverLife: [
    [0, [0.6, 1, 0.15], 0],
    [0.12, [0.75, 1, 0.2], 1],
    [0.3, null, 0.12],
    [0.45, null, 1],
    [0.62, null, 0.08],
    [0.8, null, 1],
    [1, null, 0],
  ],
  ...{ shine: true, lightEvery: 1, lightIntensity: 0.09, lightRange: 1.5 },
};

function addFire(scene: SampleScene): void {
  const fire = scene.object('Camp fire', {});
  const random = createRandom(7);
  const rock = { ...stone, repeat: 0.5, colour: [0.5, 0.48, 0.46] } as const;
  for (let i = 0; i < 12; i++) {
    const angle = (i / 12) * 2 * Math.PI + 0.1 * random();
    const size = 0.24 + 0.1 * random();
    const place = {
      position: [0.78 * Math.cos(angle), 0.06, 0.78 * Math.sin(angle)] as const,
      rotation: [random() * 3, random() * 3, random() * 3] as const,
      scale: [size * 1.25, size * 0.85, size] as const,
      parent: fire,
    };
    scene.object('Stone', place, mesh('sphere', rock));
  }
  // logs that lean against each other, charred at the top
  for (let i = 0; i < 6; i++) {
    const angle = (i / 6) * 2 * Math.PI + 0.3;
    const lean = 0.85 + 0.1 * random();
    const place = {
      position: [0.3 * Math.sin(angle), 0.25, 0.3 * Math.cos(angle)] as const,
      rotation: [0, angle, 0] as const,
      parent: fire,
    };
    const turned = scene.object('Log', place);
    const inner = { rotation: [-lean, 0, 0], scale: [0.11, 0.78, 0.11], parent: turned } as const;
    scene.object('Wood', inner, mesh('cylinder', { ...bark, colour: [0.08, 0.055, 0.045] }));
  }
  const embers = { colour: [0.02, 0.012, 0.01], emissive: [1, 0.17, 0.02], emissiveIntensity: 1.6 } as const;
  scene.object('Embers', { position: [0, 0.03, 0], scale: [1, 0.1, 1], parent: fire }, [
    'ObjectRenderer',
    { mesh: 'sphere', ...embers },
  ]);
  scene.object('Flames', { position: [0, 0.14, 0], parent: fire }, emitter(flames));
  scene.object('Sparks', { position: [0, 0.4, 0], parent: fire }, emitter(sparks));
  scene.object('Smoke', { position: [0, 1.5, 0], parent: fire }, emitter(smoke));
  // one light that casts the shadows of all flames, and sways with them
  const flicker = addClip(scene, 'Fire flickers', 1.5, [
    track(
      '',
      'Light.intensity',
      eased([0, 22], [0.13, 17], [0.27, 25], [0.4, 19], [0.62, 27], [0.8, 20], [1, 24], [1.3, 16], [1.5, 22]),
    ),
    track(
      '',
      'Transform.position',
      eased(
        [0, [0, 0.9, 0]],
        [0.35, [0.05, 1, -0.03]],
        [0.7, [-0.04, 0.86, 0.05]],
        [1.1, [0.02, 0.96, 0.03]],
        [1.5, [0, 0.9, 0]],
      ),
    ),
  ]);
  scene.object(
    'Firelight',
    { position: [0, 0.9, 0], parent: fire },
    light('point', { diffuse: [1, 0.46, 0.15], intensity: 22, range: 12, shadowMapSize: 512, shadowRadius: 3 }),
    ['Animation', { clip: flicker }],
  );
}

/** Logs to sit on, and a tent behind the fire. */
function addCamp(scene: SampleScene): void {
  for (const [x, z, turn] of [
    [-2.1, 0.5, 1.35],
    [2.1, 0.3, -1.25],
    [0.2, -2.3, 0],
  ] as const) {
    const seat = scene.object('Seat', { position: [x, 0.2, z], rotation: [0, turn, 0] });
    const trunk = { rotation: [0, 0, Math.PI / 2], scale: [0.4, 1.7, 0.4], parent: seat } as const;
    scene.object('Trunk', trunk, mesh('cylinder', bark));
  }
  const tent = scene.object('Tent', { position: [-2.9, 0, -3.6], rotation: [0, 0.75, 0] });
  const cloth = { colour: [0.42, 0.33, 0.2], roughness: 0.9 } as const;
  for (const side of [-1, 1]) {
    const place = {
      position: [side * 0.62, 0.82, 0] as const,
      rotation: [0, 0, side * 0.64] as const,
      scale: [0.03, 2.05, 2.7] as const,
      parent: tent,
    };
    scene.object('Cloth', place, mesh('box', cloth));
  }
  for (const z of [-1.3, 1.3]) {
    const place = { position: [0, 0.86, z], scale: [0.06, 1.72, 0.06], parent: tent } as const;
    scene.object('Pole', place, mesh('cylinder', bark));
  }
}

function addWood(scene: SampleScene): void {
  const fir = scene.prefab('Fir', () => {
    const tree = scene.object('Fir', {});
    scene.object('Trunk', { position: [0, 0.6, 0], scale: [0.34, 1.2, 0.34], parent: tree }, mesh('cylinder', bark));
    for (let i = 0; i < 4; i++) {
      const wide = 2.4 - 0.5 * i;
      const place = { position: [0, 1.7 + 1.05 * i, 0], scale: [wide, 1.9, wide], parent: tree } as const;
      scene.object('Branches', place, mesh('cone', leaf));
    }
    return tree;
  });
  const trees = scene.object('Wood', {});
  const random = createRandom(19);
  for (let i = 0; i < 46; i++) {
    const angle = -Math.PI * (0.02 + (0.96 * i) / 45) + 0.08 * random();
    const away = 8 + 8 * random();
    const size = 0.85 + 0.6 * random();
    const position: Vector3Tuple = [away * Math.cos(angle), 0, away * Math.sin(angle)];
    scene.instance(fir, { position, rotation: [0, 6 * random(), 0], scale: [size, size, size], parent: trees });
  }
}

/** A camp fire at night whose flames and sparks are lights, with smoke, and fireflies over the meadow. */
export async function fire(): Promise<SampleScene> {
  const scene = new SampleScene('Fire and sparks');
  Object.assign(scene.settings, {
    ...{ background: 'sky', sky: 'night', environmentIntensity: 0.55, backgroundIntensity: 1 },
    ...{ fog: 'exponential', fogFromSky: true, fogDensity: 0.018 },
    ...{ toneMapping: 'aces-filmic', exposure: 1.15, shadowCascades: 2 },
    ...{ bloom: true, bloomIntensity: 0.55, bloomThreshold: 1.1, vignette: true, vignetteDarkness: 0.45 },
  });
  const grass = {
    map: 'grass',
    normalMap: 'grass-normal',
    colour: [0.3, 0.31, 0.24],
    repeat: 24,
    roughness: 0.95,
  } as const;
  scene.object('Ground', { scale: [60, 1, 60] }, mesh('plane', grass));
  scene.object(
    'Moon',
    { position: [-8, 12, 6], target: [0, 0, 0] },
    light('directional', { diffuse: [0.5, 0.62, 1], intensity: 0.22 }),
  );
  addFire(scene);
  addCamp(scene);
  addWood(scene);
  scene.object('Fireflies', { position: [1, 1, -3.5] }, emitter(fireflies));
  addCamera(scene, [0.9, 1.35, 5.4], [0, 0.95, 0], { fov: 0.85 });
  return scene;
}
