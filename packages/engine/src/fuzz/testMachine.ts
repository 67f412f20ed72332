import { Object3D } from 'three';
import { createRandom } from '../core/createRandom';

/** What `workSeconds` takes on the reference: a core of a Xeon Platinum 8480 under Node 20, nothing else running (s). */
const REFERENCE = 0.1;

const ROUNDS = 5;

/** A fixed text of JSON (2 MB), as scenes are: objects with components with fields. */
let text = '';

function sceneLikeText(): string {
  const random = createRandom(1);
  const values = (): object => Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`field${i}`, random()]));
  const components = (): object[] => Array.from({ length: 3 }, () => ({ type: 'Component', values: values() }));
  return JSON.stringify(Array.from({ length: 2000 }, (_, i) => ({ id: `${i}`, components: components() })));
}

/** A fixed piece of work, like opening a scene and none of its code. @returns the time it worked (s) */
export function workSeconds(): number {
  const before = process.cpuUsage();
  const objects = JSON.parse(text) as { id: string; components: { values: Record<string, number> }[] }[];
  const root = new Object3D();
  for (const { id, components } of objects) {
    const object = new Object3D();
    object.userData = { id, components: components.map(({ values }) => ({ ...values })) };
    root.add(object);
  }
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1e6;
}

/**
 * How many times longer than on the reference this process needs now for the same work: 1 where it is as fast or faster. It
 * tells a slow machine, or one that is busy, from slow code.
 */
export function machineSlowness(): number {
  text ||= sceneLikeText();
  const times = Array.from({ length: ROUNDS }, workSeconds).sort((a, b) => a - b);
  return Math.max(1, times[ROUNDS >> 1] / REFERENCE);
}
