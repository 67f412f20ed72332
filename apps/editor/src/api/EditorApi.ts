import type { Command, CommandStack, Signal } from '@farol/editing';
import type { ComponentRegistry, Scene } from '@farol/engine';
import type { CustomField } from '@farol/engine/fields';
import type { UnpackQuestion } from '@farol/engine/files';
import type { SceneParameters } from '@farol/scenes';
import type { Sample } from './Sample';
import type { ComponentType } from 'react';
import type { PanelLayout } from '../layout/PanelLayout';
import type { PanelRegistry } from '../layout/PanelRegistry';
import type { MicroShaderEditing } from '../microshaders/MicroShaderEditing';
import type { Clipboard } from '../model/Clipboard';
import type { ConsoleLog } from '../model/ConsoleLog';
import type { Dialogs } from '../model/Dialogs';
import type { Drafts } from '../model/Drafts';
import type { EditorDocument } from '../model/EditorDocument';
import type { PlaceToShow } from '../model/PlaceToShow';
import type { Notices } from '../model/Notices';
import type { RecentFiles } from '../model/RecentFiles';
import type { Registry } from '../model/Registry';
import type { Timeline } from '../model/timeline/Timeline';
import type { Tour } from '../model/Tour';
import type { Tools } from '../model/Tools';
import type { Viewport } from '../viewport/Viewport';
import type { Action } from './Action';
import type { EditorPlugin } from './EditorPlugin';
import type { FieldEditorProps } from './FieldEditorProps';
import type { KeyBindings } from './KeyBindings';
import type { PreferenceStore } from './preferences';

/** The file that the document was opened from or saved to. */
export interface OpenFile {
  /** File name; null for a document that was never saved. */
  readonly name: string | null;
  /** Handle to write the file again; null in browsers that give none. */
  readonly handle: FileSystemFileHandle | null;
  /** Hash of the bytes last read or written (see `seenFile`); absent when unknown. */
  readonly seen?: string;
}

/** Stores unsaved changes, for recovery when the tab is killed. */
export interface DraftKeeper {
  /** Whether all unsaved edits are stored in the browser. */
  readonly isUpToDate: boolean;
  /** Offers unsaved scenes of killed tabs. @returns whether there are any */
  offerRecovery(): Promise<boolean>;
}

/** Control for fields of a plugin's type. */
export interface CustomFieldEditor {
  /** Name of the field type. */
  readonly id: string;
  readonly editor: ComponentType<FieldEditorProps<CustomField>>;
}

/**
 * An editor as seen by its actions, panels, fields and plugins; implemented by the class `Editor`. A page may have
 * several, each with its own registries, preferences and layout.
 */
export interface EditorApi {
  /** The edited document: scene, selection, simulation and history. */
  readonly document: EditorDocument;
  /** Canvas, cameras, gizmo and renderer. */
  readonly viewport: Viewport;
  readonly microShaders: MicroShaderEditing;
  /** Place shown by the Microshaders panel. */
  readonly microShaderPlace: PlaceToShow;
  /** Place shown by the Scripts panel. */
  readonly scriptPlace: PlaceToShow;
  readonly dialogs: Dialogs;
  readonly clipboard: Clipboard;
  /** Tool that is open over the viewport, such as the arranging of copies. */
  readonly tools: Tools;
  /** The timeline; null until the Timeline panel is first shown, see `timelineOf`. */
  timeline: Timeline | null;
  /** Messages of the Console panel. */
  readonly log: ConsoleLog;
  readonly notices: Notices;
  /** Files that the user last opened or saved. */
  readonly recentFiles: RecentFiles;
  readonly tour: Tour;
  /** Whether unsaved changes are being stored. */
  readonly drafts: Drafts;
  /** Number of other devices that show the scene, as text; empty unless the scene is shared. */
  readonly phones: { text: string; readonly changed: Signal };

  /** Registry of the commands that the user can run. */
  readonly actions: Registry<Action>;
  /** The user's key bindings. */
  readonly keys: KeyBindings<Action>;
  readonly panels: PanelRegistry;
  /** Layout of the panels. */
  readonly layout: PanelLayout;
  /** Component types that can be added, and read from files. */
  readonly components: ComponentRegistry;
  /** Controls for field types of plugins. */
  readonly fieldEditors: Registry<CustomFieldEditor>;
  readonly preferences: PreferenceStore;
  /** Plugins added by `addPlugin`; `changed` emits when one is added or removed. */
  readonly plugins: { readonly changed: Signal; readonly list: readonly EditorPlugin[] };

  /** Emits when the user asks to rename the selected object. */
  readonly renameRequested: Signal;
  /** Emits when another file or scene is opened. */
  readonly fileChanged: Signal;
  /** Samples by name. */
  readonly samples: Readonly<Record<string, Sample>>;
  /** Fulfilled when the first scene is loaded and drawn. */
  readonly ready: Promise<void>;
  /** Stores unsaved changes; null until soon after `ready`, and in browsers without the necessary storage. */
  readonly autosave: DraftKeeper | null;
  /** Whether the code for opening and saving files has been fetched, so that both work offline. */
  readonly worksOffline: boolean;
  /** The history, same as `document.commands`. */
  readonly commands: CommandStack;
  readonly file: OpenFile;

  /** Notes that the document was saved to a file. @param step - last step of the history at that time; null for none */
  saved(file: OpenFile, step: Command | null): void;
  /** The scene as JSON text, in the file format. */
  serialize(): string;
  /** Opens one of the engine's demo scenes. @throws Error (as a rejection) when it cannot be made; the present scene stays */
  openScene(name: string, parameters?: SceneParameters): Promise<void>;
  /** Opens one of `samples`. @throws Error (as a rejection) when it cannot be made or read; the present scene stays */
  openSample(name: string): Promise<void>;
  /** Asset library for the next scene: the present one if the user added nothing to it, else a new one. */
  libraryForNext(): EditorDocument['assets'];
  /**
   * Opens a file: a `.farol` container, or JSON. File and assets are checked before anything changes; a dialog lists
   * all problems of a broken file, and the present scene stays. Asks about unsaved changes before replacing the scene.
   * @param bytes - the file's bytes, or the scene as text
   * @param fileOf - gives assets that came with a text, by their paths in it
   * @returns whether the file was opened
   */
  openFileBytes(bytes: Uint8Array | string, file: OpenFile, fileOf?: (path: string) => Blob | null): Promise<boolean>;
  /** Asks before compressed data expand to a large size. */
  mayUnpack(this: void, sizes: UnpackQuestion): Promise<boolean>;
  /** Asks about unsaved changes, when there are any. @returns whether the scene may be replaced */
  mayLoseChanges(): Promise<boolean>;
  /** Runs a function. Errors become messages; cancelling a file picker is ignored. */
  attempt(run: () => unknown): void;
  /**
   * Adds everything that a plugin contains, or nothing. Components of the scene that were kept as data, since their
   * type was missing, work again.
   * @throws Error naming what exists already
   */
  addPlugin(plugin: EditorPlugin): void;
  /**
   * Removes everything that a plugin added. Its components stay in the scene as data, which are saved; undo adds the
   * plugin again.
   * @throws Error when there is no plugin of that name
   */
  removePlugin(name: string): void;
  /** Opens a microshader in its panel, at a line (from 1) if given. */
  openMicroShader(chunk: string, line?: number): void;
  /** Opens a script in its panel, at a line (from 1) if given. */
  openScript(name: string, line?: number): void;
  /**
   * Replaces the scene, with an empty history.
   * @param runsScripts - whether its scripts run; default true. Those of an untrusted scene are off until the user
   *   allows them
   */
  show(scene: Scene, file: OpenFile, runsScripts?: boolean): void;
}
