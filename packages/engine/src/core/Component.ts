import { type FieldTable, type FieldValue, sameValue, type ValuesOf } from '@farol/editing/fields';
import { defineFieldProperties } from '../fields/defineFieldProperties';
import { type AssetNames, FieldOwner, own } from '../fields/FieldOwner';
import { savedFields } from '../fields/savedFields';
import type { CostlyEvents, EngineKeyEvent, EnginePointerEvent, ObjectPointerEvent } from './events';
import type { RequiredEffect } from './RequiredEffect';
import type { ComponentClass } from './ComponentClass';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/**
 * A part of a GameObject that gives it an ability: the class to extend for a component without fields; `component({ …
 * })` makes one with fields. Fields are declared once, and read by the inspector, the file format, undo and the tests.
 */
export abstract class Component extends FieldOwner {
  static readonly typeName: string = '';
  static readonly fields: FieldTable = {};
  static readonly version: number = 1;
  static readonly unique: boolean = false;
  static readonly help: string = '';
  static readonly icon: string = 'object';
  static readonly effect: RequiredEffect | null = null;
  static readonly callable: readonly string[] | null = null;

  private attachedObject: GameObject | null = null;
  private isEnabled = true;
  private ownId = '';
  /** Values that simulation shows in place of the authored ones, by field name; null for none. */
  private simulated: Map<string, FieldValue> | null = null;

  /**
   * The scene began to play, or the component came into one that plays: called once, before its first `update`, in a
   * frame that takes time.
   */
  start?(): void;
  /**
   * Called every frame that is simulated, after every `update`, animation and physics; what follows others belongs
   * here.
   */
  lateUpdate?(deltaSeconds: number, time: number): void;
  /** A component that was started leaves the scene, or the scene is reset. */
  onDestroy?(): void;
  /** Pointer events over the canvas, while the object is active and the component enabled. */
  onPointerDown?(event: EnginePointerEvent): void;
  onPointerMove?(event: EnginePointerEvent): void;
  onPointerUp?(event: EnginePointerEvent): void;
  onPointerWheel?(event: EnginePointerEvent): void;
  onKeyDown?(event: EngineKeyEvent): void;
  onKeyUp?(event: EngineKeyEvent): void;
  /**
   * Pointer events on what is drawn of the object or of any below it: the nearest mesh under the pointer is called,
   * then the objects above it. Over and out come once, however the pointer goes from part to part; whether it is over
   * something is found out when it moves. A press and a release are of any button; a click is of the first one, pressed
   * and released over the same object, no more than 10 CSS pixels apart. Touch is over what it presses, until it is
   * lifted.
   */
  onPointerOver?(event: ObjectPointerEvent): void;
  onPointerOut?(event: ObjectPointerEvent): void;
  onPointerPress?(event: ObjectPointerEvent): void;
  onPointerRelease?(event: ObjectPointerEvent): void;
  onPointerClick?(event: ObjectPointerEvent): void;
  /** Whether it wants events that it has methods for at present ('pointer': those on objects); it does when absent. */
  listensTo?(events: CostlyEvents): boolean;

  /** Unique in its scene and kept in files; '' until the component has been on a GameObject. */
  get id(): string {
    return this.ownId;
  }

  get componentClass(): ComponentClass {
    return this.constructor as unknown as ComponentClass;
  }

  get typeName(): string {
    return this.componentClass.typeName;
  }

  override get ownerName(): string {
    return this.typeName;
  }

  /** False switches the component off without taking it away. */
  get enabled(): boolean {
    return this.isEnabled;
  }

  set enabled(value: boolean) {
    if (value === this.isEnabled) return;
    this.isEnabled = value;
    if (this.attachedObject) {
      this.onActiveChanged();
      this.attachedObject.scene?.notify({ kind: 'enabled', component: this });
    }
  }

  /**
   * The GameObject that the component is on.
   * @throws Error when it is on none
   */
  get gameObject(): GameObject {
    if (!this.attachedObject) {
      throw new Error(`This ${this.typeName} is on no GameObject: add it with gameObject.addComponent.`);
    }
    return this.attachedObject;
  }

  get isAttached(): boolean {
    return this.attachedObject !== null;
  }

  /** The scene of the GameObject, or null. */
  get scene(): Scene | null {
    return this.attachedObject?.scene ?? null;
  }

  /** Enabled, on a GameObject that is active together with all its ancestors. */
  get isActive(): boolean {
    return this.isEnabled && this.attachedObject !== null && this.attachedObject.activeInHierarchy;
  }

  override get(name: string): FieldValue {
    const shown = this.simulated?.get(name);
    return shown === undefined ? this.getAuthored(name) : shown;
  }

  override set(name: string, value: FieldValue): void {
    const shown = this.simulated?.get(name);
    super.set(name, value);
    if (shown === undefined) return;
    this.simulated!.delete(name);
    if (!sameValue(shown, this.getAuthored(name)) && this.attachedObject) this.onFieldChanged(name);
  }

  /**
   * Shows a value as long as the scene plays, or until `endSimulation` or `set`: no edit, and not saved. `get` and the
   * property of the field answer with it. Of a Transform it moves the object.
   * @throws FieldError as `set` does
   */
  simulate(name: string, value: FieldValue): void {
    this.checkValue(name, value);
    if (sameValue(this.get(name), value)) return;
    this.simulated ??= new Map();
    if (this.simulated.size === 0) this.scene?.noteSimulated(this);
    this.simulated.set(name, own(value));
    if (this.attachedObject) this.onFieldChanged(name);
  }

  /** Whether values are shown in place of authored ones. */
  get isSimulated(): boolean {
    return this.simulated !== null;
  }

  /** Shows every authored value again; `Scene.reset` does it for all components. */
  endSimulation(): void {
    const { simulated } = this;
    if (!simulated) return;
    this.simulated = null;
    if (!this.attachedObject) return;
    for (const [name, value] of simulated) {
      // a view may be gone meanwhile
      if (!Object.hasOwn(this.fields, name) || !sameValue(value, this.get(name))) this.onFieldChanged(name);
    }
  }

  /** The component came onto a GameObject; `gameObject` is there, `scene` perhaps not. */
  onAttach(): void {}

  /** The component is about to leave its GameObject. */
  onDetach(): void {}

  /** The GameObject came into a scene, or the component came onto a GameObject of one. */
  onEnterScene(_scene: Scene): void {}

  /** The GameObject, or the component alone, is about to leave the scene. */
  onLeaveScene(_scene: Scene): void {}

  /** A field got another value, by hand or by code. Called only while attached. */
  onFieldChanged(_name: string): void {}

  /** `isActive` may have changed: the component was enabled or disabled, or an object above it was. */
  onActiveChanged(): void {}

  /**
   * Called every frame that is simulated; only components that override it are visited.
   * @param deltaSeconds - 0 when the scene was put at a time
   * @param time - the scene's time in seconds
   */
  update(_deltaSeconds: number, _time: number): void {}

  /** Gives back what the component holds. It cannot be used afterwards. */
  dispose(): void {}

  protected override get assetNames(): AssetNames | null {
    return this.scene?.assets ?? null;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    if (!this.attachedObject) return;
    this.onFieldChanged(name);
    this.attachedObject.scene?.notify({ kind: 'field', component: this, field: name, before });
  }

  /** @internal Called by GameObject. */
  attachTo(gameObject: GameObject, id: string): void {
    this.attachedObject = gameObject;
    this.ownId = id;
    this.onAttach();
  }

  /** @internal Called by GameObject. */
  detach(): void {
    this.onDetach();
    this.attachedObject = null;
  }

  /** The authored value of every field; those that show a part of another one are left out. */
  authoredValues(): Record<string, FieldValue> {
    const values: Record<string, FieldValue> = {};
    for (const { name } of savedFields(this.fields)) values[name] = this.getAuthored(name);
    return values;
  }
}

/**
 * Base class with a property for each field: its static members have defaults, `typeName` and `help` are to be given.
 */
export type ComponentBase<F extends FieldTable> = Pick<
  ComponentClass,
  'typeName' | 'version' | 'unique' | 'help' | 'icon' | 'effect' | 'callable'
> & { readonly fields: F } & (abstract new () => Component & ValuesOf<F>);

/** Methods that the engine calls where a class has them: a field of such a name would be called. */
const called = /^(?:start|lateUpdate|on[A-Z]\w*)$/;

/**
 * The base class of a component with these fields, each a typed property of the instance:
 * `class RandomMovement extends component({ speed: number(1, { unit: 'm/s', help: '…' }) }) { … }`.
 * @throws Error when a field has the name of a member, or of a method that the engine calls
 */
export function component<const F extends FieldTable>(fields: F): ComponentBase<F> {
  for (const name of Object.keys(fields)) {
    if (called.test(name))
      throw new Error(`The field '${name}' has the name of a method that is called: give it another name.`);
  }
  abstract class Fielded extends Component {
    static override readonly fields = fields;
  }
  defineFieldProperties(Fielded.prototype, fields);
  return Fielded as never;
}
