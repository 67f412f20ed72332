import type { ComponentClass } from '@farol/engine';
import type { CustomField, FieldType } from '@farol/engine/fields';
import type { FarolEffect } from '@farol/renderer';
import type { Technique } from '@farol/renderer/authoring';
import type { ComponentType } from 'react';
import type { Panel } from '../layout/PanelRegistry';
import type { Action } from './Action';
import type { EditorApi } from './EditorApi';
import type { FieldEditorProps } from './FieldEditorProps';

/** A type of fields: what it allows, and what it is edited with. Declare fields of it by the engine's `custom`. */
export interface PluginFieldType extends FieldType {
  readonly editor: ComponentType<FieldEditorProps<CustomField>>;
}

/** An effect: what the Frame panel says of it, and how one is made. */
export interface PluginEffect {
  readonly label: string;
  /** One line. */
  readonly help: string;
  /** A new effect, made when it is first switched on. */
  make(): FarolEffect;
}

/** What a plugin brings; all parts but the name may be left out. See `EditorApi.addPlugin` and `removePlugin`. */
export interface EditorPlugin {
  /** Its own in an editor; named in messages. */
  readonly name: string;
  readonly panels?: readonly Panel[];
  /** Classes that extend the engine's `component({ … })`: in the menu Add component, the inspector, files and undo. */
  readonly components?: readonly ComponentClass[];
  readonly fieldTypes?: readonly PluginFieldType[];
  /** By key: in every menu of techniques. */
  readonly techniques?: Readonly<Record<string, Technique>>;
  /** By key: in the Frame panel, where each is switched. */
  readonly effects?: Readonly<Record<string, PluginEffect>>;
  /** By name: text in the form of a `.glsl` file, for `#include` in every renderer of the editor. */
  readonly microshaders?: Readonly<Record<string, string>>;
  /** Commands: in the palette, on the page of keys, and by their keys. */
  readonly actions?: readonly Action[];
  /** Called last. What it returns is called first when the plugin is removed. */
  setUp?(editor: EditorApi): (() => void) | void;
}
