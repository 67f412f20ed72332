import { readFileSync } from 'node:fs';

const file = new URL('../../../lab/reference/h200-thesis.json', import.meta.url);

/** Figures of the Lab's reference run that pages show: GPU time (ms) and bytes, by series, competitor and value. */
export default {
  load() {
    const { plan, rows, surroundings } = JSON.parse(readFileSync(file, 'utf8'));
    const shown = plan.series.filter(({ name }) => name === 'sponza-lights' || name === 'temple-lights');
    return {
      date: surroundings.date.slice(0, 10),
      series: shown.map(({ name, values }) => ({
        name: name.split('-')[0] === 'sponza' ? 'atrium' : 'temple',
        values,
        times: Object.fromEntries(
          plan.competitors
            .filter((competitor) => !['multipass', 'three-webgpu'].includes(competitor))
            .map((competitor) => [
              competitor,
              values.map((_value, index) => find(rows, name, competitor, index)?.gpu?.median ?? null),
            ]),
        ),
        bytes: Object.fromEntries(
          plan.competitors.map((competitor) => [
            competitor,
            find(rows, name, competitor, values.length - 1)?.counts?.targetBytes ?? null,
          ]),
        ),
      })),
    };
  },
};

/** @param {any[]} rows @param {string} series @param {string} competitor @param {number} index */
function find(rows, series, competitor, index) {
  return rows.find((row) => row.series === series && row.competitor === competitor && row.index === index);
}
