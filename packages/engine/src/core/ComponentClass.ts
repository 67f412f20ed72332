import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type { Component } from './Component';
import type { NewObject } from './NewObject';
import type { RequiredEffect } from './RequiredEffect';

/** A class of components with the static members that registry, menus and file format use. */
export interface ComponentClass<T extends Component = Component> {
  new (): T;
  /** Name of the component type in files and menus. */
  readonly typeName: string;
  readonly fields: FieldTable;
  /**
   * Version of the fields in files; raise it, and write `migrate`, when a field changes its name, meaning or default.
   */
  readonly version: number;
  /** Whether a GameObject can have at most one component of the type. */
  readonly unique: boolean;
  /** One-line description of the component in the Add menu. */
  readonly help: string;
  /** Name of the icon in editors; an unknown name gives a plain one. */
  readonly icon: string;
  /** The renderer effect that draws the component, such as decals; null for none. */
  readonly effect: RequiredEffect | null;
  /** Objects with the component that the Add menu offers; classes that extend this one do not inherit them. */
  readonly newObjects: readonly NewObject[];
  /**
   * Names of the methods that EventTriggers offer; null for all methods of the class and its base classes that the
   * engine does not call itself. For built-in classes, null means none.
   */
  readonly callable: readonly string[] | null;
  /** Brings field values written by an older version up to `version`. */
  migrate?(values: Record<string, unknown>, fromVersion: number): Record<string, unknown>;
}

/** Stored data of a component, independent of its class. */
export interface ComponentData {
  readonly type: string;
  /** Version of the class that wrote the values. */
  readonly version: number;
  readonly values: Readonly<Record<string, FieldValue>>;
}
