import type { SceneFacts } from './SceneFacts';

/** Facts that nearly every scene has, and that say where something is and of what colour. */
const common =
  /^(position|rotation|scale|color|ground|intensity|target|lookAt|background|angle|penumbra|shape|roughness)$/;

/** Names of the facts of a scene but the common ones, with their values where these are words. */
export function namesOf(facts: unknown, names = new Set<string>()): Set<string> {
  if (Array.isArray(facts)) facts.forEach((item) => namesOf(item, names));
  else if (typeof facts === 'object' && facts !== null)
    for (const [name, value] of Object.entries(facts)) {
      if (typeof value === 'string' && !common.test(name))
        names.add(/^(type|kind|as)$/.test(name) ? value : `${name} ${value}`);
      else if (typeof value === 'object') {
        if (Array.isArray(value) && typeof value[0] === 'string') value.forEach((item) => names.add(String(item)));
        else if (!/^(world|view|things|lights|material)$/.test(name) && !common.test(name)) names.add(name);
        namesOf(value, names);
      } else if (!common.test(name)) names.add(name);
    }
  return names;
}

/** Words for a shrunk scene: faults with the same words are of one kind. */
export function kindOf(facts: SceneFacts): string {
  const words = [...namesOf({ world: facts.world, view: facts.view }), ...namesOf(facts.things)];
  const lights = [...namesOf(facts.lights)].filter((name) => name !== 'count');
  if ((facts.lights ?? []).some(({ kind }) => kind === undefined)) lights.push('point');
  return (
    [...new Set([...words.sort(), ...lights.sort().map((name) => `light ${name}`)])].join(', ') || 'nothing special'
  );
}
