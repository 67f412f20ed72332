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

/** The file that the document is saved to. */
export interface OpenFile {
  /** Its name; null for a document that has not been saved. */
  readonly name: string | null;
  /** Where the browser lets us write again; null where it does not. */
  readonly handle: FileSystemFileHandle | null;
  /** Mark of the bytes that the document was read from, or written as, last (see `seenFile`); absent where it is not known. */
  readonly seen?: string;
}

/** What stores the document's changes for a tab that is killed. */
export interface DraftKeeper {
  /** Whether everything is stored as it is now. */
  readonly isUpToDate: boolean;
  /** Offers what tabs that were killed have left. @returns whether there was any */
  offerRecovery(): Promise<boolean>;
}

/** The control of the fields of a plugin's type. */
export interface CustomFieldEditor {
  /** Name of the type of fields. */
  readonly id: string;
  readonly editor: ComponentType<FieldEditorProps<CustomField>>;
}

/**
 * One editor, as its actions, panels, fields and plugins know it; the class `Editor` is one. Several may be on one page:
 * each has registries, preferences and a layout of its own.
 */
export interface EditorApi {
  /** Scene, selection, simulation and history. */
  readonly document: EditorDocument;
  /** Canvas, camera, gizmo and renderer. */
  readonly viewport: Viewport;
  readonly microShaders: MicroShaderEditing;
  /** What the Microshaders panel shows. */
  readonly microShaderPlace: PlaceToShow;
  /** What the Scripts panel shows. */
  readonly scriptPlace: PlaceToShow;
  readonly dialogs: Dialogs;
  readonly clipboard: Clipboard;
  /** What is open over the picture, such as copies that are being arranged. */
  readonly tools: Tools;
  /** The clip that is edited; null until the Timeline panel was first shown: see `timelineOf`. */
  timeline: Timeline | null;
  /** What the Console panel shows. */
  readonly log: ConsoleLog;
  readonly notices: Notices;
  /** The files that were last opened or saved. */
  readonly recentFiles: RecentFiles;
  readonly tour: Tour;
  /** Whether changes are kept for a tab that is killed. */
  readonly drafts: Drafts;

  /** Everything that the user can do by a key or a menu. */
  readonly actions: Registry<Action>;
  /** The user's keys for the actions. */
  readonly keys: KeyBindings<Action>;
  readonly panels: PanelRegistry;
  /** Where the panels are. */
  readonly layout: PanelLayout;
  /** Types of components that can be added, and that files may hold. */
  readonly components: ComponentRegistry;
  /** Controls of the types of fields that plugins brought. */
  readonly fieldEditors: Registry<CustomFieldEditor>;
  readonly preferences: PreferenceStore;
  /** What was added by `addPlugin`; `changed` emits when a plugin comes or goes. */
  readonly plugins: { readonly changed: Signal; readonly list: readonly EditorPlugin[] };

  /** Emits when the user asks to rename the selected object. */
  readonly renameRequested: Signal;
  /** Emits when another file, or another scene, is edited. */
  readonly fileChanged: Signal;
  /** Scenes to begin with, by name. */
  readonly samples: Readonly<Record<string, Sample>>;
  /** Fulfilled when the first scene is loaded and drawn. */
  readonly ready: Promise<void>;
  /** Stores changes; null until it has begun, soon after `ready`, and where the browser cannot. */
  readonly autosave: DraftKeeper | null;
  /** Whether the code that opens and saves files has been fetched, so that both work without a network. */
  readonly worksOffline: boolean;
  /** The history: `document.commands`. */
  readonly commands: CommandStack;
  readonly file: OpenFile;

  /** Notes that the document, as it was after a step of its history, was saved to a file. @param step - null for none */
  saved(file: OpenFile, step: Command | null): void;
  /** The scene as the text of a file. */
  serialize(): string;
  /** Opens one of the engine's scenes. @throws Error (as a rejection) when it cannot be made; the present scene stays */
  openScene(name: string, parameters?: SceneParameters): Promise<void>;
  /** Opens one of `samples`. @throws Error (as a rejection) when it cannot be made or read; the present scene stays */
  openSample(name: string): Promise<void>;
  /** A library for the scene that comes next: the present one where nothing of the user's is in it, else a new one. */
  libraryForNext(): EditorDocument['assets'];
  /**
   * Opens a file: a `.farol` container, or plain JSON. It is checked, and its assets are loaded, before anything changes:
   * of a broken file a dialog lists all problems, and the present scene stays. Of a good one the user is asked what becomes of
   * unsaved changes.
   * @param bytes - of the file, or the scene as text
   * @param fileOf - assets that came with a text, by their paths in it
   * @returns whether it was opened
   */
  openFileBytes(bytes: Uint8Array | string, file: OpenFile, fileOf?: (path: string) => Blob | null): Promise<boolean>;
  /** Asks before packed data become large. */
  mayUnpack(this: void, sizes: UnpackQuestion): Promise<boolean>;
  /** Asks what becomes of unsaved changes, when there are any. @returns whether another scene may take this one's place */
  mayLoseChanges(): Promise<boolean>;
  /** Runs something; what it throws becomes a message, save where the user turned back from choosing a file. */
  attempt(run: () => unknown): void;
  /**
   * Adds all that a plugin brings, or nothing. Components of the scene that were kept as data are themselves again.
   * @throws Error naming what there is already
   */
  addPlugin(plugin: EditorPlugin): void;
  /**
   * Takes out all that a plugin brought. Its components stay in the scene as data, which are kept and saved; undo brings
   * the plugin back.
   * @throws Error when there is no plugin of that name
   */
  removePlugin(name: string): void;
  /** Shows a microshader in its panel, at a line (from 1) if one is given. */
  openMicroShader(chunk: string, line?: number): void;
  /** Shows a script of the scene in its panel, at a line (from 1) if one is given. */
  openScript(name: string, line?: number): void;
  /**
   * Edits another scene, with an empty history.
   * @param runsScripts - whether its scripts run, as they do when absent; those of a scene of somebody else's are off until
   * the user says so
   */
  show(scene: Scene, file: OpenFile, runsScripts?: boolean): void;
}
