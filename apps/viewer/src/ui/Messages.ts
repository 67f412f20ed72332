import { t } from '@farol/editing';

/** Messages over the picture; each stays until the user closes it or one of the same subject replaces it. */
export class Messages {
  private readonly list = document.createElement('div');
  private readonly bySubject = new Map<string, HTMLElement>();

  constructor(parent: HTMLElement) {
    this.list.className = 'messages';
    this.list.setAttribute('role', 'alert');
    parent.append(this.list);
  }

  /**
   * Displays a message in place of an earlier one of the same subject; an empty text only removes the earlier one.
   *
   * @param subject - key of the subject, such as 'file'
   * @param onClose - called when the user closes the message
   */
  show(subject: string, text: string, onClose = (): void => {}): void {
    this.bySubject.get(subject)?.remove();
    this.bySubject.delete(subject);
    if (!text) return;
    const message = document.createElement('div');
    message.className = 'message';
    message.dataset.subject = subject;
    const words = document.createElement('span');
    words.textContent = text;
    const close = document.createElement('button');
    close.type = 'button';
    close.textContent = '×';
    close.setAttribute('aria-label', t('Close this message'));
    close.addEventListener('click', () => {
      this.show(subject, '');
      onClose();
    });
    message.append(words, close);
    this.bySubject.set(subject, message);
    this.list.append(message);
  }
}
