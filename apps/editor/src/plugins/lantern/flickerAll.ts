import { Light } from '@farol/engine';
import type { Action } from '../../api/Action';
import { addComponent } from '../../model/edits';
import { Flicker } from './Flicker';

/** Adds a Flicker to every object with a point or spot light. */
export const flickerAll: Action = {
  id: 'lantern.flicker-all',
  label: 'Let every lamp flicker',
  keys: ['Ctrl+Alt+L'],
  icon: 'point',
  run({ document: { scene }, commands }) {
    const lamps = scene.componentsOf(Light).filter(({ type }) => type === 'point' || type === 'spot');
    const objects = lamps.map(({ gameObject }) => gameObject).filter((object) => object.getComponent(Light));
    commands.run(addComponent(scene, objects, Flicker));
  },
};
