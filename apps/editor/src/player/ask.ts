import { shortText, t } from '@farol/editing';
import type { ForeignAddress } from '@farol/engine/files';

/** Shows a question over the page. @param answers - answers by the labels of their buttons */
function ask<T>(label: string, text: string, answers: ReadonlyMap<string, T>): Promise<T> {
  const place = document.createElement('div');
  place.setAttribute('role', 'dialog');
  place.setAttribute('aria-label', label);
  const paragraph = document.createElement('p');
  paragraph.textContent = text;
  place.append(paragraph);
  return new Promise((resolve) => {
    for (const [action, answer] of answers) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = action;
      button.addEventListener('click', () => {
        place.remove();
        resolve(answer);
      });
      place.append(button);
    }
    document.body.prepend(place);
  });
}

/** Asks whether a linked scene may load from other hosts. @returns the allowed hosts: all of them, or none */
export function askForHosts(addresses: readonly ForeignAddress[]): Promise<readonly string[]> {
  const hosts = [...new Set(addresses.map(({ origin }) => origin))];
  const listed =
    hosts
      .slice(0, 8)
      .map((host) => shortText(host, 120))
      .join('\n') + (hosts.length > 8 ? `\n${t('… and {count} more', { count: hosts.length - 8 })}` : '');
  const text = `${t('This scene asks for files of other hosts, which would learn that you open it:')}\n${listed}`;
  return ask(
    t('Files of other hosts'),
    text,
    new Map([
      [t('Load from these hosts'), hosts],
      [t('Open without them'), []],
    ]),
  );
}

/** Asks whether scripts of a linked scene may run. */
export const askForScripts = (): Promise<boolean> =>
  ask(
    t('Scripts of the scene'),
    t(
      'This scene has scripts, which are programs of whoever made the link. They reach none of your files and no other host, but may keep this device busy.',
    ),
    new Map([
      [t('Run them'), true],
      [t('Open without them'), false],
    ]),
  );
