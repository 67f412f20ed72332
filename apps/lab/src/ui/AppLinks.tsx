import { t } from '@farol/editing';
import { useEffect, useState } from 'preact/hooks';

/** Path of the lamp icon beside Farol's name, as in the editor: strokes in a square of 16 by 16. */
const LAMP = 'M8 1.8L4.4 4.6l.9 5.6h5.4l.9-5.6zM6.6 10.2v4M9.4 10.2v4';

const apps = (): [string, string][] => [
  ['editor', t('Editor')],
  ['viewer', t('Viewer')],
  ['gallery', t('Gallery of examples')],
];

/** Name of the Lab, and links to Farol's other apps, whose addresses are in `apps.json` beside the page. */
export function AppLinks() {
  const [addresses, setAddresses] = useState<Readonly<Record<string, string>>>({});
  useEffect(() => {
    fetch('./apps.json')
      .then(async (answer) => answer.ok && setAddresses((await answer.json()) as Record<string, string>))
      .catch(() => {}); // without apps.json no links are shown
  }, []);
  return (
    <div class="bar-choices">
      <p class="brand">
        <svg class="brand-lamp" viewBox="0 0 16 16" aria-hidden="true">
          <path d={LAMP} />
        </svg>
        {t('Farol Lab')}
      </p>
      <nav class="bar-choices" aria-label={t('Other pages of Farol')}>
        {apps().map(
          ([app, label]) =>
            addresses[app] !== undefined && (
              <a key={app} href={addresses[app]}>
                {label}
              </a>
            ),
        )}
      </nav>
    </div>
  );
}
