import { Camera, CharacterController, GameObject, Scene } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { expect, it } from 'vitest';
import { addPhysics } from './addPhysics';

it('puts a camera on a character that stands below it: the eye stays where it is', () => {
  const scene = new Scene();
  const camera = new GameObject('Camera');
  camera.addComponent(Camera);
  camera.transform.lookAt([4, 3, 6], [0, 0.5, 0]);
  scene.add(camera);
  scene.three.updateMatrixWorld();
  const before = JSON.stringify(serialize(scene));
  const eye = camera.transform.modelMatrix.elements.map((each) => Number(each.toFixed(6)));
  const command = addPhysics(scene, [camera], 'character');
  command.do();
  const player = camera.parent!;
  expect([player.getComponent(CharacterController) !== null, camera.getComponent(CharacterController)]).toEqual([
    true,
    null,
  ]);
  expect([player.tags, player.transform.position[1]]).toEqual([['player'], 3 - 1.65]);
  expect(camera.transform.modelMatrix.elements.map((each) => Number(each.toFixed(6)))).toEqual(eye);
  command.undo();
  expect(JSON.stringify(serialize(scene))).toBe(before);
  // an object that is no camera becomes a character itself
  const robot = new GameObject('Robot');
  scene.add(robot);
  addPhysics(scene, [robot], 'character').do();
  expect(robot.getComponent(CharacterController)).not.toBeNull();
});
