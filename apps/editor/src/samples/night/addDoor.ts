import { addClip, eased, track } from '../clips';
import { mesh, wood } from '../parts';
import type { SampleScene } from '../SampleScene';

/** Opening angle of a leaf (rad). */
const OPEN = 1.75;

/**
 * The door of the inner room: a clip opens both leaves when the player comes near, or the door is clicked.
 * @param floor - height of the floor (m)
 * @param creak - asset name of the sound
 */
export function addDoor(scene: SampleScene, floor: number, creak: string): void {
  const leaf = (side: -1 | 1): string => (side < 0 ? 'Left leaf' : 'Right leaf');
  const clip = addClip(
    scene,
    'Door opens',
    3.2,
    ([-1, 1] as const).map((side) =>
      track(
        leaf(side),
        'Transform.rotation',
        eased([0, [0, 0, 0]], [0.5, [0, -side * 0.12, 0]], [3.2, [0, -side * OPEN, 0]]),
      ),
    ),
  );
  const door = scene.object(
    'Door',
    { position: [0, floor, 6.45] },
    ['Animation', { clip, playOnStart: false, wrap: 'once' }],
    ['AudioSource', { sound: creak, playOnStart: false, maxDistance: 25, volume: 0.8 }],
  );
  const planks = { ...wood, colour: [0.5, 0.33, 0.2], repeat: 1 } as const;
  const bronze = { colour: [0.5, 0.34, 0.17], roughness: 0.35, metalness: 0.9 } as const;
  // a sensor in front of the door; animation and sound each have a trigger
  const threshold = scene.object(
    'Threshold',
    { position: [0, 1.5, 1.9], parent: door },
    ['Collider', { fit: false, size: [4.4, 3, 3.4], sensor: true }],
    ['EventTrigger', { event: 'triggerEnter', otherTag: 'player', target: door, method: 'Animation.play', once: true }],
    [
      'EventTrigger',
      { event: 'triggerEnter', otherTag: 'player', target: door, method: 'AudioSource.play', once: true },
    ],
  );
  for (const side of [-1, 1] as const) {
    const hinge = { position: [side * 1.5, 0, 0], parent: door } as const;
    const wing = scene.object(leaf(side), hinge, ['RigidBody', { type: 'kinematic' }]);
    const panel = { position: [-side * 0.745, 2.2, 0], scale: [1.48, 4.36, 0.12], parent: wing } as const;
    scene.object(
      'Panel',
      panel,
      mesh('box', planks),
      ['Collider'],
      ['EventTrigger', { event: 'pointerClick', target: threshold, method: 'EventTrigger.fire' }],
    );
    for (const y of [0.5, 2.2, 3.9]) {
      const place = { position: [-side * 0.745, y, 0], scale: [1.44, 0.12, 0.17], parent: wing } as const;
      scene.object('Band', place, mesh('box', bronze));
    }
    const ring = { position: [-side * 1.3, 1.35, 0.13], scale: [0.22, 0.22, 0.22], parent: wing } as const;
    scene.object('Ring', ring, mesh('torus', bronze));
  }
}
