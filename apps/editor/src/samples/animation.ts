import type { Vector3Tuple } from '@farol/engine/fields';
import { addClip, EASE, eased, FALL, RISE, steps, track, turn } from './clips';
import { addCamera, iron, light, mesh } from './parts';
import { SampleScene } from './SampleScene';

const paint = (colour: Vector3Tuple) => ({ colour, roughness: 0.4 });
const red = paint([0.7, 0.12, 0.08]);
const white = paint([0.85, 0.83, 0.78]);

/** A carousel: horses go up and down while all turn, by two clips at two levels of the tree. */
function addCarousel(scene: SampleScene): void {
  const spin = addClip(scene, 'Carousel turns', 12, [track('', 'Transform.rotation', turn(12))]);
  const hop = addClip(scene, 'Horse hops', 1.6, [
    track('', 'Transform.position', eased([0, [0, 0.75, 0]], [0.8, [0, 1.25, 0]], [1.6, [0, 0.75, 0]])),
  ]);
  const root = scene.object('Carousel', { position: [-4.2, 0, -2.2] }, ['Animation', { clip: spin }]);
  scene.object('Disc', { position: [0, 0.15, 0], scale: [5, 0.3, 5], parent: root }, mesh('cylinder', red));
  scene.object('Axle', { position: [0, 1.8, 0], scale: [0.4, 3.4, 0.4], parent: root }, mesh('cylinder', white));
  scene.object('Roof', { position: [0, 3.7, 0], scale: [5.4, 1.1, 5.4], parent: root }, mesh('cone', red));
  for (let i = 0; i < 6; i++) {
    const angle = (i / 6) * 2 * Math.PI;
    const place = { position: [Math.cos(angle) * 1.8, 0, Math.sin(angle) * 1.8], rotation: [0, -angle, 0] } as const;
    const seat = scene.object(`Seat ${i + 1}`, { ...place, parent: root });
    scene.object('Pole', { position: [0, 1.7, 0], scale: [0.07, 3, 0.07], parent: seat }, mesh('cylinder', white));
    // every horse plays the same clip with another offset
    const horse = scene.object('Horse', { position: [0, 0.75, 0], parent: seat }, [
      'Animation',
      { clip: hop, startTime: (i * 1.6) / 6 },
    ]);
    const coat = paint(i % 2 === 0 ? [0.8, 0.66, 0.45] : [0.32, 0.24, 0.2]);
    scene.object('Body', { scale: [0.34, 0.4, 0.95], parent: horse }, mesh('sphere', coat));
    const head = { position: [0, 0.3, 0.5], rotation: [0.7, 0, 0], scale: [0.2, 0.24, 0.5], parent: horse } as const;
    scene.object('Head', head, mesh('sphere', coat));
  }
  for (let i = 0; i < 8; i++) {
    const angle = (i / 8) * 2 * Math.PI;
    const diffuse: Vector3Tuple = i % 2 === 0 ? [1, 0.75, 0.4] : [1, 0.4, 0.3];
    scene.object(
      'Bulb',
      { position: [Math.cos(angle) * 2.5, 3.1, Math.sin(angle) * 2.5], parent: root },
      ['ObjectRenderer', { mesh: 'bulb', kind: 'basic', colour: diffuse, instanced: true }],
      ['Light', { diffuse, intensity: 4, range: 4 }],
    );
  }
}

/** A robot arm with eased keys: one clip with a track for each joint. */
function addArm(scene: SampleScene): void {
  const bend = (...keys: readonly (readonly [number, Vector3Tuple])[]) => eased(...keys);
  const clip = addClip(scene, 'Arm reaches', 6, [
    track(
      'Shoulder',
      'Transform.rotation',
      bend([0, [0, -0.9, 0]], [2, [0, 0.7, 0]], [4, [0, 0.2, 0]], [6, [0, -0.9, 0]]),
    ),
    track(
      'Shoulder/Arm',
      'Transform.rotation',
      bend([0, [0.35, 0, 0]], [2, [0.8, 0, 0]], [4, [0, 0, 0]], [6, [0.35, 0, 0]]),
    ),
    track(
      'Shoulder/Arm/Forearm',
      'Transform.rotation',
      bend([0, [1.2, 0, 0]], [2, [0.9, 0, 0]], [4, [1.7, 0, 0]], [6, [1.2, 0, 0]]),
    ),
    track('Shoulder/Arm/Forearm/Lamp/Light', 'Light.diffuse', [
      { time: 0, value: [1, 0.85, 0.6] },
      { time: 2, value: [0.45, 0.8, 1] },
      { time: 4, value: [1, 0.45, 0.7] },
      { time: 6, value: [1, 0.85, 0.6] },
    ]),
  ]);
  const steel = { colour: [0.75, 0.5, 0.1], roughness: 0.35, metalness: 0.3 } as const;
  const root = scene.object('Robot arm', { position: [3.7, 0, -2.4] }, ['Animation', { clip }]);
  scene.object('Foot', { position: [0, 0.25, 0], scale: [1.4, 0.5, 1.4], parent: root }, mesh('cylinder', iron));
  const shoulder = scene.object('Shoulder', { position: [0, 0.6, 0], rotation: [0, -0.9, 0], parent: root });
  scene.object('Ball', { scale: [0.75, 0.75, 0.75], parent: shoulder }, mesh('sphere', iron));
  const arm = scene.object('Arm', { rotation: [0.35, 0, 0], parent: shoulder });
  scene.object('Bone', { position: [0, 1, 0], scale: [0.34, 2, 0.34], parent: arm }, mesh('box', steel));
  const forearm = scene.object('Forearm', { position: [0, 2, 0], rotation: [1.2, 0, 0], parent: arm });
  scene.object('Ball', { scale: [0.5, 0.5, 0.5], parent: forearm }, mesh('sphere', iron));
  scene.object('Bone', { position: [0, 0.75, 0], scale: [0.24, 1.5, 0.24], parent: forearm }, mesh('box', steel));
  const lamp = scene.object('Lamp', { position: [0, 1.55, 0], rotation: [0.9, 0, 0], parent: forearm });
  scene.object('Shade', { scale: [0.5, 0.4, 0.5], rotation: [Math.PI, 0, 0], parent: lamp }, mesh('cone', iron));
  scene.object(
    'Light',
    { position: [0, 0.25, 0], rotation: [Math.PI / 2, 0, 0], parent: lamp },
    light('spot', { diffuse: [1, 0.85, 0.6], intensity: 90, range: 12, cutoff: 0.62, penumbra: 0.35 }),
  );
}

/** A bouncing ball with squash and stretch. */
function addBall(scene: SampleScene): void {
  const clip = addClip(scene, 'Ball bounces', 1.1, [
    track('', 'Transform.position', [
      { time: 0, value: [0, 0.34, 2.2], easing: 'bezier', control: RISE },
      { time: 0.55, value: [0, 2.3, 2.2], easing: 'bezier', control: FALL },
      { time: 1.1, value: [0, 0.34, 2.2] },
    ]),
    track('', 'Transform.scale', [
      { time: 0, value: [1.22, 0.68, 1.22], easing: 'bezier', control: EASE },
      { time: 0.12, value: [0.9, 1.15, 0.9] },
      { time: 0.55, value: [1, 1, 1] },
      { time: 1, value: [0.92, 1.12, 0.92], easing: 'bezier', control: EASE },
      { time: 1.1, value: [1.22, 0.68, 1.22] },
    ]),
  ]);
  const ball = scene.object('Ball', { position: [0, 0.34, 2.2] }, ['Animation', { clip }]);
  scene.object('Rubber', { parent: ball }, mesh('sphere', paint([0.16, 0.4, 0.75])));
}

/** A signal whose lamps switch by stepped keys. */
function addSignal(scene: SampleScene): void {
  const looks = [
    [
      'Red',
      [1, 0.1, 0.06],
      1.95,
      [
        [0, 6],
        [3, 0],
        [7, 6],
      ],
    ],
    [
      'Yellow',
      [1, 0.65, 0.08],
      1.6,
      [
        [0, 0],
        [2.4, 6],
        [3, 0],
        [6.2, 6],
        [7, 0],
      ],
    ],
    [
      'Green',
      [0.12, 1, 0.3],
      1.25,
      [
        [0, 0],
        [3, 6],
        [6.2, 0],
      ],
    ],
  ] as const;
  const clip = addClip(scene, 'Signal changes', 8, [
    ...looks.flatMap(([name, , , keys]) => [
      track(name, 'Light.intensity', steps(...keys)),
      track(
        name,
        'ObjectRenderer.emissiveIntensity',
        steps(...keys.map(([time, value]) => [time, value * 0.7] as const)),
      ),
    ]),
  ]);
  const signal = scene.object('Signal', { position: [1.2, 0, -3.6] }, ['Animation', { clip }]);
  scene.object('Post', { position: [0, 0.5, 0], scale: [0.12, 1, 0.12], parent: signal }, mesh('cylinder', iron));
  scene.object('Box', { position: [0, 1.6, -0.08], scale: [0.5, 1.3, 0.3], parent: signal }, mesh('box', iron));
  for (const [name, colour, y] of looks) {
    scene.object(
      name,
      { position: [0, y, 0.1], scale: [0.28, 0.28, 0.2], parent: signal },
      ['ObjectRenderer', { mesh: 'sphere', colour: [0.05, 0.05, 0.05], emissive: colour, emissiveIntensity: 0 }],
      ['Light', { diffuse: colour, intensity: 0, range: 4 }],
    );
  }
}

/** A fairground that shows clips: rotations, eased joints, squash, switches and colours. */
export async function animation(): Promise<SampleScene> {
  const scene = new SampleScene('Animation');
  Object.assign(scene.settings, {
    ...{
      background: 'gradient',
      skyTop: [0.02, 0.03, 0.09],
      skyHorizon: [0.2, 0.11, 0.12],
      skyGround: [0.02, 0.02, 0.02],
    },
    ...{ toneMapping: 'aces-filmic', exposure: 1.15, environmentIntensity: 1 },
    ...{ bloom: true, bloomIntensity: 0.5, bloomThreshold: 1.2 },
  });
  addCamera(scene, [1.2, 3, 9.2], [-0.2, 1.2, -1], { fov: 0.95 });
  const paving = {
    map: 'tiles',
    normalMap: 'tiles-normal',
    colour: [0.75, 0.72, 0.7],
    repeat: 10,
    roughness: 0.5,
  } as const;
  scene.object('Ground', { scale: [40, 1, 40] }, mesh('plane', paving));
  scene.object(
    'Moon',
    { position: [-7, 12, 8], target: [0, 0, 0] },
    light('directional', { diffuse: [0.6, 0.68, 1], intensity: 1.6, shadowExtent: 10 }),
  );
  addCarousel(scene);
  addArm(scene);
  addBall(scene);
  addSignal(scene);
  return scene;
}
