import { Signal } from '@farol/editing';
import type { FileProblem } from '@farol/engine/files';
import type { SessionInfo } from './SessionInfo';

/** A question with two or three answers. */
export interface ConfirmDialog {
  readonly kind: 'confirm';
  readonly title: string;
  readonly text: string;
  /** Label of the button that agrees. */
  readonly action: string;
  /** A third answer: the label of its button, and the function called before the dialog closes without agreement. */
  readonly other?: { readonly label: string; choose(): void };
}

/** A list of everything that is wrong with a file. */
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

/** Progress of a long task. */
export interface WorkProgress {
  /** Emits when the remaining time has changed. */
  readonly changed: Signal;
  /** Part of the task that is done, 0 to 1. */
  readonly share: number;
  readonly text: string;
}

/** Progress of a long task; closing the dialog cancels the task. */
export interface ProgressDialog {
  readonly kind: 'progress';
  readonly title: string;
  /** Progress; absent when unknown. */
  readonly progress?: WorkProgress;
}

/** A dialog without parameters, which shows the editor's own state. */
export interface PlainDialog {
  readonly kind: 'about' | 'agent' | 'export' | 'film' | 'keys' | 'palette' | 'phone' | 'picture';
}

/** Unsaved scenes of closed tabs, and functions to open or delete them. */
export interface RecoveryOffer {
  readonly sessions: readonly SessionInfo[];
  /** Opens the scene of a session. */
  recover(session: SessionInfo): Promise<unknown>;
  /** Deletes an unsaved scene for good. */
  discard(session: SessionInfo): Promise<void>;
}

/** Dialog that offers unsaved scenes of closed tabs. */
export interface RecoverDialog extends RecoveryOffer {
  readonly kind: 'recover';
}

/** Welcome page: samples, recent files, the tour. */
export interface WelcomeDialog {
  readonly kind: 'welcome';
  /** Null when no unsaved scene can be recovered. */
  readonly recovery: RecoveryOffer | null;
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
  | PlainDialog
  | RecoverDialog
  | WelcomeDialog;

/** The open dialog; one at a time. */
export class Dialogs {
  readonly changed = new Signal();

  /** Text typed after the command palette was opened, while its code was being fetched. */
  typed = '';

  /** Element that had the focus before a dialog opened; it is focused again after the last one closes. Null in Node. */
  before: Element | null = null;

  private request: DialogRequest | null = null;
  private answer: (agreed: boolean) => void = () => {};

  get current(): DialogRequest | null {
    return this.request;
  }

  /** Shows a dialog in place of the open one. @returns whether the user agreed */
  show(request: DialogRequest): Promise<boolean> {
    if (!this.request) this.before = globalThis.document?.activeElement ?? null;
    this.close(false);
    this.request = request;
    this.typed = '';
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
