import { shortText } from '@farol/editing';
import { boolean, choice, colour, type FieldValue, number, object, string, vector3 } from '@farol/editing/fields';
import { callEvent } from '../core/callEvent';
import type { CostlyEvents, EngineKeyEvent, ObjectPointerEvent } from '../core/events';
import { type Component, component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import { tellFault } from '../core/tellFault';
import { UnknownComponent } from '../core/UnknownComponent';
import { methodsOf } from '../triggers/methodsOf';
import { TriggerCalls } from '../triggers/TriggerCalls';

const events = [
  'start',
  'pointerOver',
  'pointerOut',
  'pointerPress',
  'pointerRelease',
  'pointerClick',
  'keyDown',
  'keyUp',
  'timer',
  'collisionEnter',
  'collisionExit',
  'triggerEnter',
  'triggerExit',
] as const;

const values = ['none', 'number', 'flag', 'text', 'colour', 'vector', 'object', 'event'] as const;

const whenEvent = (...equals: (typeof events)[number][]) => ({ field: 'event', equals });
const whenValue = (...equals: (typeof values)[number][]) => ({ field: 'valueType', equals });

/** Part of a CollisionEvent that EventTrigger reads. */
interface OtherObject {
  readonly other?: GameObject | null;
}

/** Tolerance (s) of due times, since sums of frame times round. */
const CLOSE = 1e-9;

/**
 * Calls a method (`methodsOf` lists them) when an event happens to its object. An object may have several triggers.
 * Timers and delays use the scene's time, so every run is the same.
 */
export class EventTrigger extends component({
  event: choice('pointerClick', events, {
    help: 'What has to happen.',
    optionLabels: {
      start: 'Scene starts',
      pointerOver: 'Pointer over',
      pointerOut: 'Pointer out',
      pointerPress: 'Pointer down',
      pointerRelease: 'Pointer up',
      pointerClick: 'Pointer click',
      keyDown: 'Key down',
      keyUp: 'Key up',
      timer: 'Timer',
      collisionEnter: 'Collision begins',
      collisionExit: 'Collision ends',
      triggerEnter: 'Something enters',
      triggerExit: 'Something leaves',
    },
  }),
  key: string('KeyE', {
    input: 'key',
    help: 'The key, by its place on the keyboard.',
    visibleWhen: whenEvent('keyDown', 'keyUp'),
  }),
  interval: number(1, {
    unit: 's',
    min: 0.01,
    step: 0.1,
    help: 'Time from call to call.',
    visibleWhen: whenEvent('timer'),
  }),
  repeats: number(0, {
    min: 0,
    integer: true,
    help: 'How often it calls; 0 for as long as the scene plays.',
    visibleWhen: whenEvent('timer'),
  }),
  otherTag: string('', {
    help: 'The tag that the other object must have; any object when empty.',
    label: 'Other object’s tag',
    visibleWhen: whenEvent('collisionEnter', 'collisionExit', 'triggerEnter', 'triggerExit'),
  }),
  target: object(null, { help: 'The object that is told; this one when none is chosen.', noneLabel: 'This object' }),
  method: string('', {
    choices: 'methods',
    help: 'What is called on it: a method of one of its components, or a field that gets the value.',
    label: 'Call',
  }),
  valueType: choice('none', values, {
    help: 'Type of the value that is passed; only methods and fields that take it can be chosen.',
    label: 'With',
    optionLabels: {
      none: 'No value',
      number: 'Number',
      flag: 'Yes or no',
      text: 'Text',
      colour: 'Colour',
      vector: 'Vector',
      object: 'Object',
      event: 'The event',
    },
  }),
  numberValue: number(0, { help: 'The number that is passed.', label: 'Value', visibleWhen: whenValue('number') }),
  flagValue: boolean(true, { help: 'The value that is passed.', label: 'Value', visibleWhen: whenValue('flag') }),
  textValue: string('', { help: 'The text that is passed.', label: 'Value', visibleWhen: whenValue('text') }),
  colourValue: colour([1, 1, 1], {
    help: 'The colour that is passed.',
    label: 'Value',
    visibleWhen: whenValue('colour'),
  }),
  vectorValue: vector3([0, 0, 0], {
    help: 'The vector that is passed.',
    label: 'Value',
    visibleWhen: whenValue('vector'),
  }),
  objectValue: object(null, {
    help: 'The object that is passed.',
    label: 'Value',
    visibleWhen: whenValue('object'),
  }),
  delay: number(0, { unit: 's', min: 0, step: 0.1, help: 'Time from the event to the call.' }),
  once: boolean(false, { help: 'Whether only the first event counts.', label: 'Only once' }),
}) {
  static override readonly typeName: string = 'EventTrigger';
  static override readonly icon: string = 'trigger';
  static override readonly help: string =
    'Calls a method when something happens: a click, a key, a timer, a collision.';
  static override readonly callable: readonly string[] = ['fire'];

  private hasFired = false;
  /** Scene time (s) from which the timer counts; null until started. */
  private countsFrom: number | null = null;
  private calls = 0;
  /** Last reported error, so that each is reported once. */
  private toldOf = '';

  /** Names of methods that can be called on the target. */
  get methods(): string[] {
    const { scene, target } = this;
    const found = target === null ? this.isAttached && this.gameObject : scene?.findById(target);
    return found ? methodsOf(found, this.valueType) : [];
  }

  /** Calls the trigger's method as its event would. @param event - the method's argument if `valueType` is 'event' */
  fire(event: unknown = null): void {
    const { scene } = this;
    if (!scene || !this.isActive || (this.once && this.hasFired)) return;
    this.hasFired = true;
    if (this.delay > 0) scene.system(TriggerCalls).delay(this, scene.time + this.delay - CLOSE, event);
    else this.call(event);
  }

  override listensTo(kind: CostlyEvents): boolean {
    return this.event.startsWith(kind);
  }

  override start(): void {
    if (this.event === 'start') this.fire();
  }

  override update(deltaSeconds: number, time: number): void {
    if (this.event !== 'timer' || deltaSeconds === 0) return;
    const from = (this.countsFrom ??= time - deltaSeconds);
    const { interval } = this;
    const most = this.repeats || Infinity;
    // a called method may switch the trigger off
    while (this.isActive && this.calls < most) {
      if (time < from + (this.calls + 1) * interval - CLOSE) return;
      this.calls++;
      this.fire();
    }
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.beginAnew();
  }

  override onFieldChanged(name: string): void {
    if (name === 'event' || name === 'interval') this.beginAnew();
  }

  override onDestroy(): void {
    this.beginAnew();
    this.hasFired = false;
    this.toldOf = '';
  }

  override onPointerOver(event: ObjectPointerEvent): void {
    if (this.event === 'pointerOver') this.fire(event);
  }

  override onPointerOut(event: ObjectPointerEvent): void {
    if (this.event === 'pointerOut') this.fire(event);
  }

  override onPointerPress(event: ObjectPointerEvent): void {
    if (this.event === 'pointerPress' && event.button === 0) this.fire(event);
  }

  override onPointerRelease(event: ObjectPointerEvent): void {
    if (this.event === 'pointerRelease' && event.button === 0) this.fire(event);
  }

  override onPointerClick(event: ObjectPointerEvent): void {
    if (this.event === 'pointerClick') this.fire(event);
  }

  override onKeyDown(event: EngineKeyEvent): void {
    if (this.event === 'keyDown' && event.code === this.key && !event.repeat) this.fire(event);
  }

  override onKeyUp(event: EngineKeyEvent): void {
    if (this.event === 'keyUp' && event.code === this.key) this.fire(event);
  }

  onCollisionEnter(event: OtherObject): void {
    this.onContact('collisionEnter', event);
  }

  onCollisionExit(event: OtherObject): void {
    this.onContact('collisionExit', event);
  }

  onTriggerEnter(event: OtherObject): void {
    this.onContact('triggerEnter', event);
  }

  onTriggerExit(event: OtherObject): void {
    this.onContact('triggerExit', event);
  }

  /** Calls the trigger's method on its target. @internal */
  call(event: unknown): void {
    const { scene } = this;
    if (!scene) return;
    const [type, method] = this.method.split('.');
    const target = this.target === null ? this.gameObject : scene.findById(this.target);
    if (!this.method) this.tell('has no method to call', 'choose one in its field Call');
    else if (!target) this.tell('calls an object that is gone', 'choose another in its field Target');
    else if (type === 'GameObject') this.switchObject(target, method);
    else {
      const components = target.getComponents(type);
      if (components.length === 0)
        this.tell(`calls ${this.method} of '${shortText(target.name)}', which has no ${type}`);
      for (const each of components) this.callComponent(each, method, event);
    }
  }

  private onContact(event: string, contact: OtherObject): void {
    if (this.event !== event) return;
    if (this.otherTag && !contact.other?.tags.includes(this.otherTag)) return;
    this.fire(contact);
  }

  private callComponent(called: Component, method: string, event: unknown): void {
    const scene = this.scene!;
    const { valueType } = this;
    const fields = called.fields;
    if (method === 'enable' || method === 'disable' || method === 'toggle') {
      scene.system(TriggerCalls).setEnabled(called, method === 'toggle' ? !called.enabled : method === 'enable');
    } else if (called instanceof UnknownComponent) {
      const where = `${this.method} of '${shortText(called.gameObject.name)}'`;
      this.tell(`calls ${where}, which does not run`, 'switch the scripts of the scene on, or mend this one');
    } else if (Object.hasOwn(fields, method)) {
      try {
        called.simulate(method, this.fieldValue());
      } catch (error) {
        this.tell(`calls a field with a wrong value (${(error as Error).message})`, 'choose another in its field With');
      }
    } else {
      const handed = valueType === 'event' ? event : valueType === 'object' ? this.objectOf() : this.fieldValue();
      const isThere = valueType === 'none' ? callEvent(called, method) : callEvent(called, method, handed);
      const where = `${this.method} of '${shortText(called.gameObject.name)}'`;
      if (!isThere) this.tell(`calls ${where}, which has no such method`);
    }
  }

  private objectOf(): GameObject | null {
    return this.objectValue === null ? null : (this.scene?.findById(this.objectValue) ?? null);
  }

  private fieldValue(): FieldValue {
    const { valueType } = this;
    return valueType === 'none' || valueType === 'event' ? null : this.get(`${valueType}Value`);
  }

  private switchObject(target: GameObject, method: string): void {
    const calls = this.scene!.system(TriggerCalls);
    if (method === 'activate' || method === 'deactivate' || method === 'toggle')
      calls.setActive(target, method === 'toggle' ? !target.active : method === 'activate');
    else this.tell(`calls ${this.method}, which GameObjects do not have`);
  }

  private beginAnew(): void {
    this.countsFrom = null;
    this.calls = 0;
  }

  /** Reports an error once; the scene continues. */
  private tell(fault: string, mend = 'choose another in its field Call'): void {
    if (fault === this.toldOf) return;
    this.toldOf = fault;
    tellFault(this, `It ${fault}: ${mend}.`);
  }
}
