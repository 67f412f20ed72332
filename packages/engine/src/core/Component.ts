import { type FieldTable, type FieldValue, sameValue, type ValuesOf } from '@farol/editing/fields';
import { defineFieldProperties } from '../fields/defineFieldProperties';
import { type AssetNames, BaseFieldOwner, own } from '../fields/FieldOwner';
import { savedFields } from '../fields/savedFields';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import type { RequiredEffect } from './RequiredEffect';
import type {
  Component as ComponentType,
  ComponentClass,
  CostlyEvents,
  GameObject,
  ObjectPointerEvent,
  Scene,
} from './SceneGraph';

/** The base of every class of components: see the interface. Users know the class as `Component`. */
export abstract class BaseComponent extends BaseFieldOwner implements ComponentType {
  static readonly typeName: string = '';
  static readonly fields: FieldTable = {};
  static readonly version: number = 1;
  static readonly unique: boolean = false;
  static readonly help: string = '';
  static readonly effect: RequiredEffect | null = null;
  static readonly callable: readonly string[] | null = null;

  private attachedObject: GameObject | null = null;
  private isEnabled = true;
  private ownId = '';
  /** What simulation shows in place of authored values. */
  private simulated: Map<string, FieldValue> | null = null;

  start?(): void;
  lateUpdate?(deltaSeconds: number, time: number): void;
  onDestroy?(): void;
  onPointerDown?(event: EnginePointerEvent): void;
  onPointerMove?(event: EnginePointerEvent): void;
  onPointerUp?(event: EnginePointerEvent): void;
  onPointerWheel?(event: EnginePointerEvent): void;
  onKeyDown?(event: EngineKeyEvent): void;
  onKeyUp?(event: EngineKeyEvent): void;
  onPointerOver?(event: ObjectPointerEvent): void;
  onPointerOut?(event: ObjectPointerEvent): void;
  onPointerPress?(event: ObjectPointerEvent): void;
  onPointerRelease?(event: ObjectPointerEvent): void;
  onPointerClick?(event: ObjectPointerEvent): void;
  listensTo?(events: CostlyEvents): boolean;

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

  get gameObject(): GameObject {
    if (!this.attachedObject) {
      throw new Error(`This ${this.typeName} is on no GameObject: add it with gameObject.addComponent.`);
    }
    return this.attachedObject;
  }

  get isAttached(): boolean {
    return this.attachedObject !== null;
  }

  get scene(): Scene | null {
    return this.attachedObject?.scene ?? null;
  }

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

  simulate(name: string, value: FieldValue): void {
    this.checkValue(name, value);
    if (sameValue(this.get(name), value)) return;
    this.simulated ??= new Map();
    if (this.simulated.size === 0) this.scene?.noteSimulated(this);
    this.simulated.set(name, own(value));
    if (this.attachedObject) this.onFieldChanged(name);
  }

  get isSimulated(): boolean {
    return this.simulated !== null;
  }

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

  onAttach(): void {}

  onDetach(): void {}

  onEnterScene(_scene: Scene): void {}

  onLeaveScene(_scene: Scene): void {}

  onFieldChanged(_name: string): void {}

  onActiveChanged(): void {}

  update(_deltaSeconds: number, _time: number): void {}

  dispose(): void {}

  protected override get assetNames(): AssetNames | null {
    return this.scene?.assets ?? null;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    if (!this.attachedObject) return;
    this.onFieldChanged(name);
    this.attachedObject.scene?.notify({ kind: 'field', component: this, field: name, before });
  }

  attachTo(gameObject: GameObject, id: string): void {
    this.attachedObject = gameObject;
    this.ownId = id;
    this.onAttach();
  }

  detach(): void {
    this.onDetach();
    this.attachedObject = null;
  }

  authoredValues(): Record<string, FieldValue> {
    const values: Record<string, FieldValue> = {};
    for (const { name } of savedFields(this.fields)) values[name] = this.getAuthored(name);
    return values;
  }
}

export type Component = ComponentType;

/** The class to extend for a component without fields; `component({ … })` makes one with fields. */
export const Component = BaseComponent;

/** Base class with a property for each field: its static members have defaults, `typeName` and `help` are to be given. */
export type ComponentBase<F extends FieldTable> = Pick<
  ComponentClass,
  'typeName' | 'version' | 'unique' | 'help' | 'effect' | 'callable'
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
  abstract class Fielded extends BaseComponent {
    static override readonly fields = fields;
  }
  defineFieldProperties(Fielded.prototype, fields);
  return Fielded as never;
}
