import type { ComponentClass } from '@farol/engine';
import type { CustomField, FieldType } from '@farol/engine/fields';
import type { FarolEffect } from '@farol/renderer';
import type { Technique } from '@farol/renderer/authoring';
import type { ComponentType } from 'react';
import type { Panel } from '../layout/PanelRegistry';
import type { Action } from './Action';
import type { EditorApi } from './EditorApi';
import type { FieldEditorProps } from './FieldEditorProps';

/** A field type: its allowed values, and its control. Such fields are declared with the engine's `custom`. */
export interface PluginFieldType extends FieldType {
  readonly editor: ComponentType<FieldEditorProps<CustomField>>;
}

/** An effect: its texts in the Frame panel, and its constructor. */
export interface PluginEffect {
  readonly label: string;
  /** Short description, one line. */
  readonly help: string;
  /** Creates the effect, when it is first switched on. */
  make(): FarolEffect;
}

/** A plugin; all parts but the name are optional. See `EditorApi.addPlugin` and `removePlugin`. */
export interface EditorPlugin {
  /** Unique name, used in messages. */
  readonly name: string;
  readonly panels?: readonly Panel[];
  /** Classes that extend the engine's `component({ … })`; available in the Add menu, inspector, files and undo. */
  readonly components?: readonly ComponentClass[];
  readonly fieldTypes?: readonly PluginFieldType[];
  /** Techniques by key; available in every menu of techniques. */
  readonly techniques?: Readonly<Record<string, Technique>>;
  /** Effects by key; switched in the Frame panel. */
  readonly effects?: Readonly<Record<string, PluginEffect>>;
  /** Microshaders by name, as text of a `.glsl` file; can be included in all shaders of the editor. */
  readonly microshaders?: Readonly<Record<string, string>>;
  /** Actions; available in the palette, on the page of keys, and by their keys. */
  readonly actions?: readonly Action[];
  /** Called after everything else was added. The returned function is called first when the plugin is removed. */
  setUp?(editor: EditorApi): (() => void) | void;
}
