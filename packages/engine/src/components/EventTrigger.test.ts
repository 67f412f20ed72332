import { type FieldValue, number } from '@farol/editing/fields';
import { beforeEach, expect, test } from 'vitest';
import './index';
import { builtinComponents } from '../core/builtinComponents';
import { Component, component } from '../core/Component';
import { ComponentRegistry } from '../core/ComponentRegistry';
import type { EngineKeyEvent } from '../core/events';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { makeUnknownComponent } from '../core/UnknownComponent';
import { serialize } from '../files/serialize';
import { EventTrigger } from './EventTrigger';
import { Light } from './Light';

/** Stands for the component class of a user's script. */
class Door extends component({ speed: number(1, { help: 'Speed.' }) }) {
  static override readonly typeName: string = 'Door';
  readonly opened: unknown[][] = [];
  open(...values: unknown[]): void {
    this.opened.push([this.scene!.time, ...values]);
  }
  fail(): void {
    throw new Error('The hinge broke.');
  }
  _hidden(): void {}
  get isOpen(): boolean {
    return this.opened.length > 0;
  }
  override update(): void {}
}

let scene: Scene;
let object: GameObject;
let door: Door;
let errors: string[];

beforeEach(() => {
  scene = new Scene({ registry: new ComponentRegistry([...builtinComponents.types.values(), Door]) });
  errors = [];
  scene.onComponentError = (each, error) => errors.push(`${each.typeName}: ${(error as Error).message}`);
  object = new GameObject('Lamp');
  door = object.addComponent(Door);
  scene.add(object);
});

const trigger = (values: Record<string, FieldValue>): EventTrigger =>
  object.addComponent(EventTrigger, { method: 'Door.open', ...values });

const key = (type: 'down' | 'up', code: string, repeat = false): void =>
  scene.dispatchKey({ type, code, key: '', repeat } as EngineKeyEvent);

test('each event calls, and no other does', () => {
  const pointer = { button: 0 } as never;
  const contact = { other: object } as never;
  const happen: Record<string, (on: EventTrigger) => void> = {
    start: () => scene.update(0.01),
    pointerOver: (on) => on.onPointerOver(pointer),
    pointerOut: (on) => on.onPointerOut(pointer),
    pointerPress: (on) => on.onPointerPress(pointer),
    pointerRelease: (on) => on.onPointerRelease(pointer),
    pointerClick: (on) => on.onPointerClick(pointer),
    keyDown: () => key('down', 'KeyE'),
    keyUp: () => key('up', 'KeyE'),
    collisionEnter: (on) => on.onCollisionEnter(contact),
    collisionExit: (on) => on.onCollisionExit(contact),
    triggerEnter: (on) => on.onTriggerEnter(contact),
    triggerExit: (on) => on.onTriggerExit(contact),
    timer: () => scene.update(1),
  };
  expect(Object.keys(happen).toSorted()).toEqual([...EventTrigger.fields.event.options].toSorted());
  for (const event of EventTrigger.fields.event.options) {
    scene.reset();
    const on = trigger({ event });
    for (const other of Object.keys(happen)) {
      const before = door.opened.length;
      happen[other](on);
      expect(door.opened.length - before, `${other} of ${event}`).toBe(other === event ? 1 : 0);
    }
    object.removeComponent(on);
  }
});

test('keys by their code, without their repeats; keys are the scene’s only while one is wanted', () => {
  const on = trigger({ event: 'keyDown', key: 'Space' });
  expect(scene.takesKeys).toBe(true);
  key('down', 'KeyE');
  key('down', 'Space');
  key('down', 'Space', true);
  expect(door.opened).toHaveLength(1);
  on.event = 'timer';
  expect(scene.takesKeys).toBe(false);
  expect([on.listensTo('key'), on.listensTo('pointer')]).toEqual([false, false]);
  on.event = 'pointerOver';
  expect(on.listensTo('pointer')).toBe(true);
});

test('a timer calls at whole intervals of the scene’s time, whatever the frames are', () => {
  const times = (steps: readonly number[]): number[] => {
    door.opened.length = 0;
    scene.reset();
    for (const step of steps) scene.update(step);
    return door.opened.map(([time]) => Math.round((time as number) * 1e6) / 1e6);
  };
  const on = trigger({ event: 'timer', interval: 0.25, repeats: 3 });
  expect(times(Array.from({ length: 20 }, () => 0.05))).toEqual([0.25, 0.5, 0.75]);
  expect(times([0.1, 0.1, 0.1, 0.4, 0.5])).toEqual([0.3, 0.7, 1.2]);
  // three calls in one long frame
  expect(times([1])).toEqual([1, 1, 1]);
  on.repeats = 0;
  expect(times(Array.from({ length: 1000 }, () => 1 / 60))).toHaveLength(66);
  const sleeps = (seconds: number): void => {
    for (let i = 0; i < seconds * 20; i++) scene.update(0.05);
  };
  times([0.2]);
  object.active = false;
  sleeps(1);
  object.active = true;
  sleeps(0.2);
  expect(door.opened).toHaveLength(0);
  sleeps(0.05);
  expect(door.opened).toHaveLength(1);
});

test('hands the value over that is chosen', () => {
  const handed = (valueType: string, values: Record<string, FieldValue> = {}): unknown[] => {
    const on = trigger({ event: 'keyDown', valueType, ...values });
    on.fire('the event');
    object.removeComponent(on);
    return door.opened.pop()!.slice(1);
  };
  expect(handed('none')).toEqual([]);
  expect(handed('number', { numberValue: 7 })).toEqual([7]);
  expect(handed('flag', { flagValue: false })).toEqual([false]);
  expect(handed('text', { textValue: 'slowly' })).toEqual(['slowly']);
  expect(handed('colour', { colourValue: [1, 0, 0.5] })).toEqual([[1, 0, 0.5]]);
  expect(handed('vector', { vectorValue: [1, 2, 3] })).toEqual([[1, 2, 3]]);
  expect(handed('object', { objectValue: object.id })).toEqual([object]);
  expect(handed('object')).toEqual([null]);
  expect(handed('event')).toEqual(['the event']);
});

test('offers what the target can do: switches, methods of the user’s, and fields that the value fits', () => {
  const light = new GameObject('Other');
  light.addComponent(Light);
  scene.add(light);
  const on = trigger({});
  expect(on.methods).toEqual([
    ...['GameObject.activate', 'GameObject.deactivate', 'GameObject.toggle'],
    ...['Door.open', 'Door.fail', 'Door.enable', 'Door.disable', 'Door.toggle'],
    ...['EventTrigger.fire', 'EventTrigger.enable', 'EventTrigger.disable', 'EventTrigger.toggle'],
  ]);
  on.target = light.id;
  on.valueType = 'colour';
  expect(on.methods).toContain('Light.toggle');
  expect(on.methods).toContain('Light.diffuse');
  expect(on.methods).not.toContain('Light.intensity');
  on.target = 'gone';
  expect(on.methods).toEqual([]);
});

test('switches and fields are simulation: a reset puts all back, bit for bit', () => {
  const lamp = new GameObject('Other');
  const light = lamp.addComponent(Light, { intensity: 2 });
  scene.add(lamp);
  const target = lamp.id;
  trigger({ event: 'start', target, method: 'Light.toggle' });
  trigger({ event: 'start', target, method: 'Light.intensity', valueType: 'number', numberValue: 9 });
  trigger({ event: 'timer', target, method: 'GameObject.deactivate' });
  trigger({ event: 'timer', method: 'EventTrigger.disable' });
  const before = JSON.stringify(serialize(scene));
  scene.update(0.1);
  expect([light.enabled, light.intensity, lamp.active]).toEqual([false, 9, true]);
  scene.update(1);
  expect(lamp.active).toBe(false);
  scene.reset();
  expect([light.enabled, light.intensity, lamp.active]).toEqual([true, 2, true]);
  expect(JSON.stringify(serialize(scene))).toBe(before);
  expect(errors).toEqual([]);
});

test('a reset puts back the first state of what was switched several times', () => {
  const lamp = new GameObject('Other');
  const light = lamp.addComponent(Light);
  const off = new GameObject('Off');
  const dark = off.addComponent(Light);
  dark.enabled = off.active = false;
  scene.add(lamp).add(off);
  for (const [target, method] of [lamp.id, off.id].flatMap((id) => [
    [id, 'Light.toggle'],
    [id, 'GameObject.toggle'],
  ]))
    trigger({ event: 'keyDown', target, method });
  const states = (): boolean[] => [light.enabled, lamp.active, dark.enabled, off.active];
  for (const times of [1, 2, 3]) {
    scene.update(0.1);
    for (let i = 0; i < times; i++) key('down', 'KeyE');
    expect(states()).toEqual(times === 2 ? [true, true, false, false] : [false, false, true, true]);
    scene.reset();
    expect(states()).toEqual([true, true, false, false]);
  }
});

test('waits, and calls even when its object was switched off meanwhile; once is once until a reset', () => {
  trigger({ event: 'keyDown', delay: 0.5, once: true });
  trigger({ event: 'keyUp', method: 'GameObject.activate', delay: 1 });
  trigger({ event: 'keyUp', method: 'GameObject.deactivate' });
  scene.update(0.1);
  key('down', 'KeyE');
  key('down', 'KeyE');
  key('up', 'KeyE');
  for (let i = 0; i < 4; i++) scene.update(0.1);
  expect([door.opened.length, object.active]).toEqual([0, false]);
  scene.update(0.1);
  expect(door.opened).toHaveLength(1);
  for (let i = 0; i < 5; i++) scene.update(0.1);
  expect(object.active).toBe(true);
  key('down', 'KeyE');
  for (let i = 0; i < 6; i++) scene.update(0.1);
  expect(door.opened).toHaveLength(1);
  scene.reset();
  scene.update(0.1);
  key('down', 'KeyE');
  scene.reset();
  for (let i = 0; i < 6; i++) scene.update(0.1);
  // the reset has dropped pending calls
  expect(door.opened).toHaveLength(1);
  key('down', 'KeyE');
  for (let i = 0; i < 6; i++) scene.update(0.1);
  expect(door.opened).toHaveLength(2);
});

test('the other object of a collision must have the tag', () => {
  const on = trigger({ event: 'triggerEnter', otherTag: 'player' });
  const other = new GameObject('Walker');
  on.onTriggerEnter({ other });
  other.tags = ['enemy', 'player'];
  on.onTriggerEnter({ other });
  on.onTriggerEnter({ other: null });
  expect(door.opened).toHaveLength(1);
});

test('what cannot be called is told once, with object, trigger and mend; what the method throws is the method’s', () => {
  const tellOf = (values: Record<string, FieldValue>): string[] => {
    const on = trigger(values);
    on.fire();
    on.fire();
    object.removeComponent(on);
    return errors.splice(0);
  };
  const said = (fault: string, mend = 'choose another in its field Call'): string[] => [
    `EventTrigger: It ${fault}: ${mend}.`,
  ];
  expect(tellOf({ method: 'Light.enable' })).toEqual(said("calls Light.enable of 'Lamp', which has no Light"));
  expect(tellOf({ method: 'Door.close' })).toEqual(said("calls Door.close of 'Lamp', which has no such method"));
  expect(tellOf({ target: 'gone' })).toEqual(
    said('calls an object that is gone', 'choose another in its field Target'),
  );
  expect(tellOf({ method: '' })).toEqual(said('has no method to call', 'choose one in its field Call'));
  // the script is off: its data are kept, and the method need not be chosen again
  object.addComponent(makeUnknownComponent({ type: 'Gate', version: 1, values: {} }));
  expect(tellOf({ method: 'Gate.lift' })).toEqual(
    said("calls Gate.lift of 'Lamp', which does not run", 'switch the scripts of the scene on, or mend this one'),
  );
  expect(tellOf({ method: 'GameObject.explode' })).toEqual(
    said('calls GameObject.explode, which GameObjects do not have'),
  );
  expect(tellOf({ method: 'Door.fail' })).toEqual(['Door: The hinge broke.', 'Door: The hinge broke.']);
  expect(tellOf({ method: 'Door.speed', valueType: 'text' })[0]).toMatch(
    /Door\.speed must be.*: choose another in its field With\.$/,
  );
});

test('built-in components offer what they name, and each name is a method of theirs', () => {
  for (const type of builtinComponents.types.values())
    for (const name of type.callable ?? [])
      expect(typeof (type.prototype as Record<string, unknown>)[name], `${type.typeName}.${name}`).toBe('function');
  const other = new GameObject('Player');
  other.addComponent('Animation');
  other.addComponent('AudioSource');
  scene.add(other);
  const on = trigger({ target: other.id });
  expect(on.methods).toEqual(expect.arrayContaining(['Animation.play', 'Animation.stop', 'AudioSource.pause']));
  expect(on.methods).not.toContain('Animation.evaluate');
});

test('a class with methods of its own is offered those, and those it inherits from another such class', () => {
  class Gate extends Door {
    static override readonly typeName: string = 'Gate';
    lift(): void {}
  }
  class Plain extends Component {
    static override readonly typeName = 'Plain';
    static override readonly callable = ['one'];
    one(): void {}
    two(): void {}
  }
  object.addComponent(Gate);
  object.addComponent(Plain);
  const { methods } = trigger({});
  expect(methods).toEqual(expect.arrayContaining(['Gate.lift', 'Gate.open', 'Plain.one']));
  expect(methods).not.toContain('Plain.two');
});
