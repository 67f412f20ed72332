import { Signal } from '@farol/editing';
import type { FileProblem } from '@farol/engine/files';
import type { SessionInfo } from './SessionInfo';

/** A question with two answers, or three. */
export interface ConfirmDialog {
  readonly kind: 'confirm';
  readonly title: string;
  readonly text: string;
  /** What the button that agrees says. */
  readonly action: string;
  /** A third answer: its button, and what is called before the dialog closes without agreement. */
  readonly other?: { readonly label: string; choose(): void };
}

/** Everything that is wrong with a file. */
export interface ProblemsDialog {
  readonly kind: 'problems';
  readonly title: string;
  readonly text: string;
  readonly problems: readonly FileProblem[];
  /** What the button that agrees says; there is none when absent. */
  readonly action?: string;
  /** What the other button says then; 'Cancel' when absent. */
  readonly refusal?: string;
  /** What the list is of, for those who hear it. */
  readonly listLabel?: string;
}

/** Something that takes long; closing the dialog cancels it. */
export interface ProgressDialog {
  readonly kind: 'progress';
  readonly title: string;
}

/** The keys that there are. */
export interface KeysDialog {
  readonly kind: 'keys';
}

/** Everything that can be done, found by typing. */
export interface PaletteDialog {
  readonly kind: 'palette';
}

/** Scenes that were not saved when their tab was closed. */
export interface RecoveryOffer {
  readonly sessions: readonly SessionInfo[];
  /** Opens what a session left. */
  recover(session: SessionInfo): Promise<unknown>;
  /** Throws a session away. */
  discard(session: SessionInfo): Promise<void>;
}

/** Scenes that were not saved when their tab was closed. */
export interface RecoverDialog extends RecoveryOffer {
  readonly kind: 'recover';
}

/** Where one begins: samples, recent files, the tour. */
export interface WelcomeDialog {
  readonly kind: 'welcome';
  /** Null where there is nothing to recover. */
  readonly recovery: RecoveryOffer | null;
}

/** What the editor is. */
export interface AboutDialog {
  readonly kind: 'about';
}

/** The ways to give a scene away. */
export interface ExportDialog {
  readonly kind: 'export';
}

/** A question whose answer is a line of text. */
export interface TextDialog {
  readonly kind: 'text';
  readonly title: string;
  /** What the field is called. */
  readonly label: string;
  /** What it begins with. */
  readonly value: string;
  /** What the button that agrees says. */
  readonly action: string;
  /** Takes the text, without blanks at its ends; never an empty one. */
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
  | ExportDialog;

/** The dialog that is asked for, one at a time. */
export class Dialogs {
  /** Emits when a dialog opens or closes. */
  readonly changed = new Signal();

  private request: DialogRequest | null = null;
  private answer: (agreed: boolean) => void = () => {};

  get current(): DialogRequest | null {
    return this.request;
  }

  /** Shows a dialog, in place of one that is open. @returns whether the user agreed */
  show(request: DialogRequest): Promise<boolean> {
    this.close(false);
    this.request = request;
    this.changed.emit();
    return new Promise((resolve) => {
      this.answer = resolve;
    });
  }

  /** Closes the dialog with an answer. */
  close(agreed: boolean): void {
    if (!this.request) return;
    this.request = null;
    this.answer(agreed);
    this.changed.emit();
  }
}
