import type { FieldTable, ValuesOf } from './Field';
import { defineFieldProperties } from './defineFieldProperties';
import { Component } from '../core/Component';

type Constructor<T> = abstract new () => T;

/**
 * The base class of a component with these fields, each a typed property of the instance:
 * `class RandomMovement extends component({ speed: number(1, { unit: 'm/s', help: '…' }) }) { … }`.
 */
export function component<const F extends FieldTable>(
  fields: F,
): Omit<typeof Component, 'prototype' | 'fields'> & Constructor<Component & ValuesOf<F>> & { readonly fields: F } {
  abstract class Fielded extends Component {
    static override readonly fields = fields;
  }
  defineFieldProperties(Fielded.prototype, fields);
  return Fielded as never;
}
