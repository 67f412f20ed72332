import { formatTime, Signal, t } from '@farol/editing';

/** Whether drafts of unsaved changes are stored, and the reason for the user when they are not. */
export class Drafts {
  /** Emits when drafts can no longer be stored, or can again. */
  readonly changed = new Signal();

  private reason: string | null = null;
  private lastKept: number | null = null;

  /** Why drafts are not stored, since when, and the remedy, in whole sentences; null while they are stored. */
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

  /** Time of the last draft, or when it should have been stored (ms since 1970); null when none can ever be stored. */
  get since(): number | null {
    return this.lastKept;
  }

  /**
   * Notes that drafts are not stored.
   * @param reason - a sentence, without a capital
   * @param since - time of the last draft, or when one was due (ms since 1970); null when none can ever be
   */
  fail(reason: string, since: number | null = null): void {
    if (this.reason === reason && this.lastKept === since) return;
    this.reason = reason;
    this.lastKept = since;
    this.changed.emit();
  }

  /** Notes that unsaved changes are being stored. */
  work(): void {
    if (this.reason === null) return;
    this.reason = null;
    this.changed.emit();
  }
}
