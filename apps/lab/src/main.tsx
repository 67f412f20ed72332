import { type Language, showPageLanguage, startPageLanguage, t, type Texts } from '@farol/editing';
import { render } from 'preact';
import { LabPage } from './ui/LabPage';
import { NoStart, webglProblem } from './ui/NoStart';
import { applyTheme, storedTheme } from './ui/support/theme';
import './style.css';

// with `?headless` the page has no user interface, and serves `npm run bench`
if (new URLSearchParams(location.search).has('headless')) {
  void import('./labHandle').then(({ installLabHandle }) => installLabHandle());
} else void startPageLanguage(spanish).then(showPage);

async function spanish(): Promise<Texts> {
  return (await import('./language/es')).es;
}

function showPage(): void {
  applyTheme(storedTheme());
  const place = document.getElementById('app')!;
  place.replaceChildren();
  const speak = async (language: Language): Promise<void> => {
    if (await showPageLanguage(language, spanish)) draw();
  };
  const draw = (): void => {
    document.title = t('Farol Lab');
    const problem = webglProblem();
    render(problem ? <NoStart problem={problem} /> : <LabPage onLanguage={speak} />, place);
  };
  draw();
}
