import { type FieldTable, type FieldValue, sameValue, type ValuesOf } from '@farol/editing/fields';
import { defineFieldProperties } from '../fields/defineFieldProperties';
import { type AssetNames, FieldOwner, frozenCopy } from '../fields/FieldOwner';
import { savedFields } from '../fields/savedFields';
import type { CostlyEvents, EngineKeyEvent, EnginePointerEvent, ObjectPointerEvent } from './events';
import type { RequiredEffect } from './RequiredEffect';
import type { ComponentClass } from './ComponentClass';
import type { GameObject } from './GameObject';
import type { NewObject } from './NewObject';
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
  static readonly newObjects: readonly NewObject[] = [];
  static readonly callable: readonly string[] | null = null;

  private attachedObject: GameObject | null = null;
  private isEnabled = true;
  private ownId = '';
  /** Values that simulation shows in place of the authored ones, by field name; null for none. */
  private simulated: Map<string, FieldValue> | null = null;

  /**
   * Called once, before the first `update`, when the scene begins to play or the component enters a playing scene, in
   * the first frame with a time step above 0.
   */
  start?(): void;
  /**
   * Called in every simulated frame after all `update` calls, animation and physics; code that follows other objects
   * belongs here.
   */
  lateUpdate?(deltaSeconds: number, time: number): void;
  /** Called when a started component leaves the scene, or the scene is reset. */
  onDestroy?(): void;
  /** Called when a pointer is pressed over the canvas, while the object is active and the component enabled. */
  onPointerDown?(event: EnginePointerEvent): void;
  onPointerMove?(event: EnginePointerEvent): void;
  onPointerUp?(event: EnginePointerEvent): void;
  onPointerWheel?(event: EnginePointerEvent): void;
  onKeyDown?(event: EngineKeyEvent): void;
  onKeyUp?(event: EngineKeyEvent): void;
  /**
   * Pointer events on meshes of the object or its descendants: called on the object of the nearest mesh under the
   * pointer, then on its ancestors. Over and out are called once, even if the pointer crosses several parts; they are
   * evaluated when the pointer moves. Presses and releases are of any button; a click is of the primary one, pressed
   * and released over the same object within 10 CSS pixels. A touch stays over the object that it pressed, until it is
   * lifted.
   */
  onPointerOver?(event: ObjectPointerEvent): void;
  onPointerOut?(event: ObjectPointerEvent): void;
  onPointerPress?(event: ObjectPointerEvent): void;
  onPointerRelease?(event: ObjectPointerEvent): void;
  onPointerClick?(event: ObjectPointerEvent): void;
  /** Whether the component wants events of a kind at present ('pointer': events on objects); true when absent. */
  listensTo?(events: CostlyEvents): boolean;

  /** Id of the component, unique in its scene and kept in files; '' until the component has been on a GameObject. */
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

  /** False switches the component off without removing it. */
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

  /** The GameObject that the component is on. @throws Error when it is on none */
  get gameObject(): GameObject {
    if (!this.attachedObject) {
      throw new Error(`This ${this.typeName} is on no GameObject: add it with gameObject.addComponent.`);
    }
    return this.attachedObject;
  }

  get isAttached(): boolean {
    return this.attachedObject !== null;
  }

  /** The scene that the GameObject is in; null outside of scenes. */
  get scene(): Scene | null {
    return this.attachedObject?.scene ?? null;
  }

  /** Whether the component is enabled, and its GameObject active together with all its ancestors. */
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
   * Shows a field's value while the scene plays, until `endSimulation` or `set`: neither an edit nor saved. `get` and
   * the field's property return the shown value. On a Transform, moves the object.
   * @throws FieldError as `set` does
   */
  simulate(name: string, value: FieldValue): void {
    this.checkValue(name, value);
    if (sameValue(this.get(name), value)) return;
    this.simulated ??= new Map();
    if (this.simulated.size === 0) this.scene?.noteSimulated(this);
    this.simulated.set(name, frozenCopy(value));
    if (this.attachedObject) this.onFieldChanged(name);
  }

  /** Whether simulation shows values of fields in place of the authored ones. */
  get isSimulated(): boolean {
    return this.simulated !== null;
  }

  /** Replaces simulated values by the authored ones; `Scene.reset` calls it for all components. */
  endSimulation(): void {
    const { simulated } = this;
    if (!simulated) return;
    this.simulated = null;
    if (!this.attachedObject) return;
    for (const [name, value] of simulated) {
      // a field may be gone, if it was a view of another field's part: this is reported as a change too
      if (!Object.hasOwn(this.fields, name) || !sameValue(value, this.get(name))) this.onFieldChanged(name);
    }
  }

  /** Called after the component was put on a GameObject; `gameObject` is set, `scene` may be null. */
  onAttach(): void {}

  /** Called before the component leaves its GameObject. */
  onDetach(): void {}

  /** Called after the component entered a scene, alone or with its GameObject. */
  onEnterScene(_scene: Scene): void {}

  /** Called before the component leaves the scene, alone or with its GameObject. */
  onLeaveScene(_scene: Scene): void {}

  /** Called after a field's value changed, by hand or by code; only while attached. */
  onFieldChanged(_name: string): void {}

  /** Called when `isActive` may have changed: the component, its object or an ancestor was switched on or off. */
  onActiveChanged(): void {}

  /**
   * Called every frame that is simulated; components whose class does not override the method are skipped.
   * @param deltaSeconds - 0 when the scene was moved to a time
   * @param time - the scene's time in seconds
   */
  update(_deltaSeconds: number, _time: number): void {}

  /** Releases the component's resources; the component cannot be used afterwards. */
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

  /** Authored values of all fields, without views (fields that show a part of another field). */
  authoredValues(): Record<string, FieldValue> {
    const values: Record<string, FieldValue> = {};
    for (const { name } of savedFields(this.fields)) values[name] = this.getAuthored(name);
    return values;
  }
}

/**
 * Base class with a property for each field, and the members of `C`. Its static members have defaults, but subclasses must
 * set `typeName` and `help`.
 */
export type ComponentBase<F extends FieldTable, C extends Component = Component> = Pick<
  ComponentClass,
  'typeName' | 'version' | 'unique' | 'help' | 'icon' | 'effect' | 'newObjects' | 'callable'
> & { readonly fields: F } & (abstract new () => C & ValuesOf<F>);

/** Names of methods that the engine calls if present; forbidden as names of fields, which would be called. */
const called = /^(?:start|lateUpdate|on[A-Z]\w*)$/;

/**
 * The base class of a component with these fields, each a typed property of the instance:
 * `class RandomMovement extends component({ speed: number(1, { unit: 'm/s', help: '…' }) }) { … }`.
 * @throws Error when a field has the name of a member, or of a method that the engine calls
 */
export function component<const F extends FieldTable>(fields: F): ComponentBase<F> {
  for (const name of Object.keys(fields)) {
    if (called.test(name))
      throw new Error(`The field '${name}' has the name of a method of components: give it another name.`);
  }
  abstract class Fielded extends Component {
    static override readonly fields = fields;
  }
  defineFieldProperties(Fielded.prototype, fields);
  return Fielded as never;
}
