import type { Vector3Tuple } from '@farol/engine/fields';
import { addCamera, iron, light, mesh, wood } from './parts';
import { SampleScene } from './SampleScene';

const hues: readonly Vector3Tuple[] = [
  [0.75, 0.2, 0.14],
  [0.8, 0.5, 0.12],
  [0.22, 0.5, 0.3],
  [0.16, 0.36, 0.65],
];

/** A wall of bricks, to be knocked down by the wrecking ball. */
function addWall(scene: SampleScene): void {
  const brick = scene.prefab('Brick', () =>
    scene.object(
      'Brick',
      {},
      mesh('box', { map: 'plaster', normalMap: 'plaster-normal', colour: hues[0], roughness: 0.8 }),
      ['Collider', { friction: 0.6 }],
      ['RigidBody', { mass: 1.5 }],
    ),
  );
  const wall = scene.object('Wall', { position: [0, 0, -1] });
  for (let row = 0; row < 7; row++) {
    for (let column = 0; column < 6; column++) {
      const x = (column - 2.5 + (row % 2) * 0.5) * 0.62;
      const place = { position: [x, 0.15 + row * 0.3, 0], scale: [0.6, 0.3, 0.34], parent: wall } as const;
      scene.instance(brick, place, { 'Brick/ObjectRenderer.colour': hues[(row + column) % hues.length] });
    }
  }
}

/** A heavy ball on a chain, which starts raised beside the wall and swings into it. */
function addWreckingBall(scene: SampleScene): void {
  const crane = scene.object('Crane', { position: [0, 0, -0.5] });
  for (const x of [-3.1, 3.1]) {
    scene.object('Post', { position: [x, 2.3, 0], scale: [0.16, 4.6, 0.16], parent: crane }, mesh('box', iron));
  }
  scene.object('Beam', { position: [0, 4.6, 0], scale: [6.4, 0.2, 0.2], parent: crane }, mesh('box', iron));
  const [length, lifted] = [3.4, 1.05];
  const ball = scene.object(
    'Wrecking ball',
    {
      position: [0, 4.5 - length * Math.cos(lifted), length * Math.sin(lifted)],
      rotation: [-lifted, 0, 0],
      parent: crane,
    },
    ['RigidBody', { mass: 60, angularDamping: 0 }],
    ['Joint', { type: 'ball', anchor: [0, length, 0] }],
  );
  const steel = { ...iron, roughness: 0.3 } as const;
  scene.object('Sphere', { scale: [0.8, 0.8, 0.8], parent: ball }, mesh('sphere', steel), [
    'Collider',
    { shape: 'sphere' },
  ]);
  const chain = { position: [0, length / 2, 0], scale: [0.05, length, 0.05], parent: ball } as const;
  scene.object('Chain', chain, mesh('cylinder', steel));
}

/** A lamp on a spring, and a gate on hinges that balls push open. */
function addSpringAndGate(scene: SampleScene): void {
  const stand = scene.object('Stand', { position: [4.1, 0, -2.6] });
  scene.object('Post', { position: [0, 1.7, 0], scale: [0.12, 3.4, 0.12], parent: stand }, mesh('box', iron));
  scene.object('Bracket', { position: [-0.5, 3.4, 0], scale: [1.2, 0.1, 0.1], parent: stand }, mesh('box', iron));
  const lamp = scene.object(
    'Lamp on a spring',
    { position: [-1, 1.7, 0], parent: stand },
    ['RigidBody', { mass: 2, linearDamping: 0.05 }],
    [
      'Joint',
      {
        type: 'spring',
        ownPartnerAnchor: true,
        partnerAnchor: [3.1, 3.35, -2.6],
        restLength: 0.9,
        stiffness: 60,
        damping: 0.3,
      },
    ],
  );
  const glow = { colour: [0.2, 0.1, 0.03], emissive: [1, 0.6, 0.2], emissiveIntensity: 5 } as const;
  scene.object(
    'Globe',
    { scale: [0.36, 0.36, 0.36], parent: lamp },
    ['ObjectRenderer', { mesh: 'sphere', ...glow }],
    ['Collider', { shape: 'sphere' }],
  );
  scene.object('Light', { parent: lamp }, [
    'Light',
    { diffuse: [1, 0.65, 0.3], intensity: 14, range: 6, castShadow: true, shadowMapSize: 512, shadowRadius: 2 },
  ]);
  const gate = scene.object(
    'Gate',
    { position: [-2.4, 0.62, 1.15] },
    ['RigidBody', { mass: 3, angularDamping: 0.6 }],
    ['Joint', { type: 'hinge', anchor: [0, 0, 0.55], axis: [0, 1, 0] }],
  );
  scene.object('Leaf', { scale: [0.08, 1.1, 1.1], parent: gate }, mesh('box', wood), ['Collider']);
}

/** Dominoes in an arc; the first one leans. */
function addDominoes(scene: SampleScene): void {
  const domino = scene.prefab('Domino', () =>
    scene.object(
      'Domino',
      {},
      mesh('box', { ...wood, repeat: 0.6 }),
      ['Collider', { friction: 0.35 }],
      ['RigidBody', { mass: 0.5 }],
    ),
  );
  const row = scene.object('Dominoes', {});
  for (let i = 0; i < 22; i++) {
    const angle = -0.35 + i * 0.085;
    const position: Vector3Tuple = [3.1 + Math.sin(angle) * 3.6 - 1.6, 0.4, 4.2 - Math.cos(angle) * 3.6 + 0.4];
    const lean = i === 0 ? 0.28 : 0;
    const place = { position, rotation: [0, -angle, -lean] as const, scale: [0.12, 0.8, 0.4] as const, parent: row };
    scene.instance(domino, place);
  }
}

/** Balls that roll down a ramp of boards. */
function addRamp(scene: SampleScene): void {
  const ramp = scene.object('Ramp', { position: [-4.2, 0, 0.6] });
  for (let i = 0; i < 3; i++) {
    const tilt = i % 2 === 0 ? -0.2 : 0.2;
    const place = {
      position: [i % 2 === 0 ? 0 : 0.55, 2.9 - i * 0.85, 0],
      rotation: [0, 0, tilt],
      scale: [2.6, 0.08, 0.9],
    } as const;
    scene.object('Board', { ...place, parent: ramp }, mesh('box', wood), ['Collider', { friction: 0.3 }]);
    for (const z of [-0.47, 0.47]) {
      const rail = {
        ...place,
        position: [place.position[0], place.position[1] + 0.1, z],
        scale: [2.6, 0.28, 0.05],
      } as const;
      scene.object('Rail', { ...rail, parent: ramp }, mesh('box', wood), ['Collider']);
    }
  }
  for (const [x, z] of [
    [-1.2, -0.52],
    [1.75, -0.52],
    [-1.2, 0.52],
    [1.75, 0.52],
  ] as const) {
    const post = { position: [x, 1.6, z], scale: [0.08, 3.2, 0.08], parent: ramp } as const;
    scene.object('Post', post, mesh('box', iron));
  }
  const ball = scene.prefab('Ball', () =>
    scene.object(
      'Ball',
      {},
      mesh('sphere', { colour: hues[3], roughness: 0.25 }),
      ['Collider', { shape: 'sphere', restitution: 0.3, friction: 0.4 }],
      ['RigidBody', { mass: 0.8, angularDamping: 0.5 }],
    ),
  );
  const balls = scene.object('Balls', { parent: ramp });
  for (let i = 0; i < 10; i++) {
    const place = {
      position: [-0.8, 3.7 + i * 0.7, 0.1 * ((i % 3) - 1)],
      scale: [0.34, 0.34, 0.34],
    } as const;
    scene.instance(ball, { ...place, parent: balls }, { 'Ball/ObjectRenderer.colour': hues[i % hues.length] });
  }
}

/** Low walls that keep rolling objects on the ground plane. */
function addKerb(scene: SampleScene): void {
  const kerb = scene.object('Kerb', {});
  const stone = {
    map: 'stone',
    normalMap: 'stone-normal',
    colour: [0.7, 0.68, 0.64],
    repeat: 1,
    roughness: 0.85,
  } as const;
  for (const [x, z, width, depth] of [
    [0, -4.6, 13.2, 0.3],
    [0, 5.6, 13.2, 0.3],
    [-6.6, 0.5, 0.3, 10.2],
    [6.6, 0.5, 0.3, 10.2],
  ] as const) {
    const place = { position: [x, 0.15, z], scale: [width, 0.3, depth], parent: kerb } as const;
    scene.object('Kerbstone', place, mesh('box', stone), ['Collider']);
  }
}

/**
 * Examples of rigid bodies: a wall that is knocked down, dominoes, balls on a ramp, a ball on a chain, a gate on
 * hinges.
 */
export async function physics(): Promise<SampleScene> {
  const scene = new SampleScene('Physics');
  Object.assign(scene.settings, {
    ...{
      background: 'gradient',
      skyTop: [0.1, 0.16, 0.3],
      skyHorizon: [0.5, 0.47, 0.45],
      skyGround: [0.1, 0.09, 0.08],
    },
    ...{ toneMapping: 'aces-filmic', exposure: 0.85, environmentIntensity: 0.55, shadowCascades: 2 },
  });
  addCamera(scene, [0.6, 3.6, 9.6], [-0.2, 1.1, 0], { fov: 0.92 });
  const paving = {
    map: 'tiles',
    normalMap: 'tiles-normal',
    colour: [0.62, 0.6, 0.57],
    repeat: 12,
    roughness: 0.6,
  } as const;
  scene.object('Ground', { scale: [40, 1, 40] }, mesh('plane', paving), [
    'Collider',
    { fit: false, offset: [0, -0.5, 0] },
  ]);
  scene.object(
    'Sun',
    { position: [-6, 10, 7], target: [0, 0, 0] },
    light('directional', { diffuse: [1, 0.88, 0.72], intensity: 2.2, shadowExtent: 11 }),
  );
  addWall(scene);
  addWreckingBall(scene);
  addDominoes(scene);
  addRamp(scene);
  addSpringAndGate(scene);
  addKerb(scene);
  return scene;
}
