import { render } from 'preact';
import { LabPage } from './ui/LabPage';
import { NoStart, webglProblem } from './ui/NoStart';
import { applyTheme, storedTheme } from './ui/support/theme';
import './style.css';

// for npm run bench
if (new URLSearchParams(location.search).has('headless')) {
  void import('./labHandle').then(({ installLabHandle }) => installLabHandle());
} else showPage();

function showPage(): void {
  applyTheme(storedTheme());
  const place = document.getElementById('app')!;
  place.replaceChildren();
  const problem = webglProblem();
  render(problem ? <NoStart problem={problem} /> : <LabPage />, place);
}
