import type { SampleScene } from '../SampleScene';

/** The player, at the end of the path, facing the temple. @param step - asset name of the sound of a step */
export function addPlayer(scene: SampleScene, step: string): void {
  const player = scene.object(
    'Player',
    { position: [1.9, 0, 22.4], target: [-0.6, 0, 8], tags: ['player'] },
    ['CharacterController', { walkSpeed: 2.6, stepHeight: 0.4, mass: 75 }],
    ['AudioSource', { sound: step, playOnStart: false, positional: false, volume: 0.5 }],
    ['Footsteps'],
  );
  scene.activeCamera = scene.object(
    'Camera',
    { position: [0, 1.68, 0], rotation: [0.1, 0, 0], parent: player },
    ['Camera', { fov: 1.05, near: 0.08, far: 120 }],
    ['AudioListener'],
  );
}
