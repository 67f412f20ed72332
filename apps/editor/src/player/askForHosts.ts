import { t } from '@farol/editing';
import { shortText } from '@farol/renderer';
import type { ForeignAddress } from '@farol/engine/files';

/** Asks whether the scene of a link may load from other hosts. @returns the hosts: all of them, or none */
export function askForHosts(addresses: readonly ForeignAddress[]): Promise<readonly string[]> {
  const hosts = [...new Set(addresses.map(({ origin }) => origin))];
  const place = document.createElement('div');
  place.setAttribute('role', 'dialog');
  place.setAttribute('aria-label', t('Files of other hosts'));
  const text = document.createElement('p');
  const listed =
    hosts
      .slice(0, 8)
      .map((host) => shortText(host, 120))
      .join('\n') + (hosts.length > 8 ? `\n${t('… and {count} more', { count: hosts.length - 8 })}` : '');
  text.textContent = `${t('This scene asks for files of other hosts, which would learn that you open it:')}\n${listed}`;
  place.append(text);
  return new Promise((resolve) => {
    const add = (label: string, answer: readonly string[]): void => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = label;
      button.addEventListener('click', () => {
        place.remove();
        resolve(answer);
      });
      place.append(button);
    };
    add(t('Load from these hosts'), hosts);
    add(t('Open without them'), []);
    document.body.prepend(place);
  });
}

/** From here on the page fetches from itself and these hosts alone, whatever is in the scene. */
export function keepToHosts(hosts: readonly string[]): void {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  const allowed = hosts.filter((host) => /^https?:\/\/[\w.:[\]-]+$/.test(host));
  policy.content = `connect-src 'self' data: blob: ${allowed.join(' ')}`;
  document.head.append(policy);
}
