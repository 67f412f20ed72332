import { Signal } from '@farol/editing';
import type { FileProblem } from '@farol/engine/files';
import type { SessionInfo } from './SessionInfo';

/** Asks the user a question with two answers, or three. */
export interface ConfirmDialog {
  readonly kind: 'confirm';
  readonly title: string;
  readonly text: string;
  /** Label of the button that agrees. */
  readonly action: string;
  /** A third answer: the label of its button, and the function called before the dialog closes without agreement. */
  readonly other?: { readonly label: string; choose(): void };
}

/** Lists everything that is wrong with a file. */
export interface ProblemsDialog {
  readonly kind: 'problems';
  readonly title: string;
  readonly text: string;
  readonly problems: readonly FileProblem[];
  /** Label of the button that agrees; without it the dialog can only be closed. */
  readonly action?: string;
  /** Label of the button that refuses beside `action`; 'Cancel' when absent. */
  readonly refusal?: string;
  /** Name of the list for screen readers. */
  readonly listLabel?: string;
}

/** How far a long task is. */
export interface WorkProgress {
  /** Emits when the rest has changed. */
  readonly changed: Signal;
  /** Part of the task that is done, 0 to 1. */
  readonly share: number;
  readonly text: string;
}

/** Progress of a long task; closing the dialog cancels the task. */
export interface ProgressDialog {
  readonly kind: 'progress';
  readonly title: string;
  /** How far it is; absent when that is not known. */
  readonly progress?: WorkProgress;
}

/** Lists the keyboard shortcuts. */
export interface KeysDialog {
  readonly kind: 'keys';
}

/** Palette of all actions, found by typing. */
export interface PaletteDialog {
  readonly kind: 'palette';
  /** Text typed while the palette's code was fetched. */
  typed?: string;
}

/** Unsaved scenes of tabs that were closed. */
export interface RecoveryOffer {
  readonly sessions: readonly SessionInfo[];
  /** Opens the scene of a session. */
  recover(session: SessionInfo): Promise<unknown>;
  /** Deletes an unsaved scene for good. */
  discard(session: SessionInfo): Promise<void>;
}

/** Offers unsaved scenes of tabs that were closed. */
export interface RecoverDialog extends RecoveryOffer {
  readonly kind: 'recover';
}

/** Welcome page: samples, recent files, the tour. */
export interface WelcomeDialog {
  readonly kind: 'welcome';
  /** Null when no unsaved scene can be recovered. */
  readonly recovery: RecoveryOffer | null;
}

/** Tells about the editor: version, licence. */
export interface AboutDialog {
  readonly kind: 'about';
}

/** Lists the formats that a scene can be exported to. */
export interface ExportDialog {
  readonly kind: 'export';
}

/** Address of the scene for phones and headsets. */
export interface PhoneDialog {
  readonly kind: 'phone';
}

/** Size and background of a picture that is saved. */
export interface PictureDialog {
  readonly kind: 'picture';
}

/** Format, size, time and camera of a film that is saved. */
export interface FilmDialog {
  readonly kind: 'film';
}

/** Asks whether agents may edit, and says how one is set up. */
export interface AgentDialog {
  readonly kind: 'agent';
}

export interface TextDialog {
  readonly kind: 'text';
  readonly title: string;
  readonly label: string;
  /** Text in the field when the dialog opens. */
  readonly value: string;
  /** Label of the button that agrees. */
  readonly action: string;
  /** Called with the trimmed text, which is never empty. */
  accept(value: string): void;
}

export type DialogRequest =
  | ConfirmDialog
  | ProgressDialog
  | ProblemsDialog
  | TextDialog
  | KeysDialog
  | PaletteDialog
  | RecoverDialog
  | WelcomeDialog
  | AboutDialog
  | ExportDialog
  | PhoneDialog
  | PictureDialog
  | FilmDialog
  | AgentDialog;

/** The open dialog; one at a time. */
export class Dialogs {
  /** Emits when a dialog opens or closes. */
  readonly changed = new Signal();

  private request: DialogRequest | null = null;
  private answer: (agreed: boolean) => void = () => {};

  get current(): DialogRequest | null {
    return this.request;
  }

  /** Shows a dialog in place of the open one. @returns whether the user agreed */
  show(request: DialogRequest): Promise<boolean> {
    this.close(false);
    this.request = request;
    this.changed.emit();
    return new Promise((resolve) => {
      this.answer = resolve;
    });
  }

  /** Closes the dialog. @param agreed - the user's answer */
  close(agreed: boolean): void {
    if (!this.request) return;
    this.request = null;
    this.answer(agreed);
    this.changed.emit();
  }
}
