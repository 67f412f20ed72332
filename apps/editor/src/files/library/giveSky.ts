import { type Command, type FieldEdit, SetFields, t } from '@farol/editing';
import { GameObject, Light, type Scene } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';
import { Euler, Matrix4, Vector3 } from 'three';
import { Sequence } from '../../model/commands/Sequence';
import { SetProperty } from '../../model/commands/SetProperty';
import { addObject } from '../../model/edits';
import type { LibrarySky } from '../../model/library/skies';

const edits = (owner: FieldOwner, values: LibrarySky['settings']): FieldEdit[] =>
  Object.entries(values).map(([name, value]) => ({ owner, name, value }));

/** Rotation (rad) after which an object's -Z axis points from a position towards the origin. */
function turnFrom(from: readonly [number, number, number]): [number, number, number] {
  const matrix = new Matrix4().lookAt(new Vector3(...from), new Vector3(), new Vector3(0, 1, 0));
  const { x, y, z } = new Euler().setFromRotationMatrix(matrix);
  return [x, y, z];
}

/**
 * Gives the scene a sky. Its first directional light at the top of the tree becomes the sun or moon; where there is
 * none, one is added. Ambient and hemisphere lights are switched off, since the sky lights the scene.
 * @param name - the sky's name, in the user's language
 * @param selected - ids selected now
 */
export function giveSky(scene: Scene, name: string, sky: LibrarySky, selected: readonly string[]): Command {
  const label = t('Changed the sky to {name}', { name });
  const lights = scene.componentsOf(Light);
  const sun = lights.find(({ type, gameObject }) => type === 'directional' && gameObject.parent === null);
  const fills = lights.filter(({ type, enabled }) => enabled && (type === 'hemisphere' || type === 'ambient'));
  const steps: (() => Command)[] = [() => new SetFields(label, edits(scene.settings, sky.settings))];
  if (fills.length > 0) steps.push(() => new SetProperty(label, fills, 'enabled', false));
  if (sun) steps.push(() => new SetProperty(label, [sun], 'enabled', sky.sun !== null));
  if (sun && sky.sun) {
    const turned = { owner: sun.gameObject.transform, name: 'rotation', value: turnFrom(sky.sun.from) };
    const values = edits(sun, sky.sun.values);
    steps.push(() => new SetFields(label, [turned, ...values]));
  } else if (sky.sun) {
    const made = new GameObject(t('Sun'));
    made.addComponent(Light, { type: 'directional', ...sky.sun.values });
    made.transform.position = [0, 4, 0];
    made.transform.rotation = turnFrom(sky.sun.from);
    steps.push(() => addObject(scene, made, scene, selected));
  }
  return new Sequence(label, steps);
}
