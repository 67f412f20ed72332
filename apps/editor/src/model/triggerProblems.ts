import { type Command, SetFields, t } from '@farol/editing';
import { Collider, type EventTrigger, type GameObject, RigidBody, type Scene } from '@farol/engine';
import { SetProperty } from './commands/SetProperty';
import { addComponent } from './edits';

/** A reason why a trigger can never fire, or calls nothing. */
export interface TriggerProblem {
  readonly text: string;
  /** A change that solves the problem; null when the user has to decide. */
  readonly mend: { readonly label: string; make(): Command } | null;
}

type Mend = TriggerProblem['mend'];

/** Colliders whose contacts an object is notified of: its own, and on a rigid body also those of its descendants. */
function collidersOf(object: GameObject): Collider[] {
  const isBody = object.getComponent(RigidBody) !== null;
  const found = [...object.getComponents(Collider)];
  const visit = (each: GameObject): void => {
    for (const child of each.children) {
      if (child.getComponent(RigidBody)) continue;
      found.push(...child.getComponents(Collider));
      visit(child);
    }
  };
  if (isBody) visit(object);
  return found.filter(({ enabled }) => enabled);
}

/** Objects that move through the scene: characters first, then bodies that are not fixed. */
const movers = (scene: Scene): GameObject[] => [
  ...scene.componentsOf('CharacterController').map(({ gameObject }) => gameObject),
  ...scene
    .componentsOf(RigidBody)
    .filter(({ type }) => type !== 'fixed')
    .map(({ gameObject }) => gameObject),
];

function hasTag(scene: Scene, tag: string): boolean {
  let found = false;
  scene.traverse(({ tags }) => void (found ||= tags.includes(tag)));
  return found;
}

/** Missing colliders, or ones of the wrong kind, of a trigger that waits for contacts. */
function ofColliders(scene: Scene, { event, gameObject }: EventTrigger): TriggerProblem[] {
  const isSensing = event.startsWith('trigger');
  if (gameObject.getComponent('CharacterController') && !isSensing) return [];
  const colliders = collidersOf(gameObject);
  if (colliders.length === 0) {
    const make = (): Command => addComponent(scene, [gameObject], Collider, { sensor: isSensing });
    const label = isSensing ? t('Add a sensor') : t('Add a collider');
    return [{ text: t('The object has no collider: nothing can enter or touch it.'), mend: { label, make } }];
  }
  if (colliders.some(({ sensor }) => sensor === isSensing)) return [];
  const edits = colliders.map((owner) => ({ owner, name: 'sensor', value: isSensing }));
  const label = isSensing ? t('Make it a sensor') : t('Make it solid');
  const text = isSensing
    ? t('The collider is no sensor: objects stop at it, and do not enter.')
    : t('The collider is a sensor: objects pass it, and do not collide.');
  return [{ text, mend: { label, make: () => new SetFields(label, edits) } }];
}

/** Problems of the objects that may set off a trigger: none has its tag, or none moves. */
function ofOthers(scene: Scene, trigger: EventTrigger): TriggerProblem[] {
  const { otherTag: tag, gameObject } = trigger;
  const others = movers(scene).filter((each) => each !== gameObject);
  if (tag === '') {
    if (others.length > 0 || movers(scene).length > 0) return [];
    return [{ text: t('Nothing in the scene moves by physics: add a player, or a body.'), mend: null }];
  }
  if (hasTag(scene, tag)) return [];
  const [first] = others;
  const name = first?.name ?? '';
  const give = (): Command =>
    new SetProperty(t('Gave {name} the tag {tag}', { name, tag }), [first], 'tags', [...first.tags, tag]);
  const clear = (): Command =>
    new SetFields(t('Cleared the tag of a trigger'), [{ owner: trigger, name: 'otherTag', value: '' }]);
  const mend: Mend = first
    ? { label: t('Give it to {name}', { name }), make: give }
    : { label: t('Any object may'), make: clear };
  return [{ text: t('No object has the tag “{tag}”.', { tag }), mend }];
}

/** Problems of a trigger's target: it no longer exists, or lacks the method. */
function ofTarget(scene: Scene, trigger: EventTrigger): TriggerProblem[] {
  const target = trigger.target === null ? trigger.gameObject : scene.findById(trigger.target);
  if (!target) {
    const label = t('Call this object');
    const make = (): Command => new SetFields(label, [{ owner: trigger, name: 'target', value: null }]);
    return [{ text: t('The object that the trigger calls no longer exists.'), mend: { label, make } }];
  }
  const { methods, method } = trigger;
  if (method !== '' && methods.includes(method)) return [];
  // proposes methods of the target's other components first: switching things on or off is rarely what is meant
  const meant = methods.filter(
    (each) => !/^(GameObject|EventTrigger|Collider)\.|\.(enable|disable|toggle)$/.test(each),
  );
  const best = meant.at(0) ?? 'GameObject.toggle';
  const label = t('Call {method}', { method: best });
  const make = (): Command => new SetFields(label, [{ owner: trigger, name: 'method', value: best }]);
  const { name } = target;
  // methods of scripts are unknown while these are off or being compiled
  const isKnown = method === '' || !target.components.some(({ typeName }) => typeName === method.split('.')[0]);
  if (!isKnown) return [];
  const text = method === '' ? t('The trigger calls no method yet.') : t('{name} has no {method}.', { name, method });
  return [{ text, mend: { label, make } }];
}

/** Reasons why a trigger does nothing while the scene plays. */
export function triggerProblems(trigger: EventTrigger): TriggerProblem[] {
  const { scene, event } = trigger;
  if (!scene) return [];
  const isOfContacts = event.startsWith('trigger') || event.startsWith('collision');
  return [
    ...(isOfContacts ? [...ofColliders(scene, trigger), ...ofOthers(scene, trigger)] : []),
    ...ofTarget(scene, trigger),
  ];
}
