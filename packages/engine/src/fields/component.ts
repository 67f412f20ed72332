import type { FieldTable, ValuesOf } from '@farol/editing/fields';
import { BaseComponent } from '../core/Component';
import type { Component, ComponentClass } from '../core/SceneGraph';
import { defineFieldProperties } from './defineFieldProperties';

/** What a class of components extends: its static members have defaults, `typeName` and `help` are to be given. */
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
