import { formatTime, Signal, t } from '@farol/editing';

/** Whether changes are kept for a tab that is killed, as the user is told it. */
export class Drafts {
  /** Emits when drafts are kept no longer, or again. */
  readonly changed = new Signal();

  private reason: string | null = null;
  private lastKept: number | null = null;

  /** Why drafts are not kept, since when, and what to do: whole sentences. Null while they are. */
  get problem(): string | null {
    if (this.reason === null) return null;
    const { reason } = this;
    return this.lastKept === null
      ? t('This browser keeps no drafts here: {reason} Save to a file by Ctrl+S.', { reason })
      : t('This browser keeps no drafts here since {time}: {reason} Save to a file by Ctrl+S.', {
          reason,
          time: formatTime(this.lastKept),
        });
  }

  /** When something was last kept, or should have been (ms since 1970); null where nothing ever can be. */
  get since(): number | null {
    return this.lastKept;
  }

  /**
   * Drafts are not kept.
   * @param reason - a sentence, without a capital
   * @param since - when something was last kept (ms since 1970); null where nothing ever can be
   */
  fail(reason: string, since: number | null = null): void {
    if (this.reason === reason && this.lastKept === since) return;
    this.reason = reason;
    this.lastKept = since;
    this.changed.emit();
  }

  /** Drafts are kept. */
  work(): void {
    if (this.reason === null) return;
    this.reason = null;
    this.changed.emit();
  }
}
