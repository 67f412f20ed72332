import DefaultTheme from 'vitepress/theme-without-fonts';
import Costs from './Costs.vue';
import Drawing from './Drawing.vue';
import Example from './Example.vue';
import Gallery from './Gallery.vue';
import Live from './Live.vue';
import './style.css';

/** @type {import('vitepress').Theme} */
export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    app.component('Costs', Costs);
    app.component('Drawing', Drawing);
    app.component('Example', Example);
    app.component('Gallery', Gallery);
    app.component('Live', Live);
  },
};
