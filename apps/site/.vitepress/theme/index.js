import DefaultTheme from 'vitepress/theme-without-fonts';
import Live from './Live.vue';
import './style.css';

/** @type {import('vitepress').Theme} */
export default {
  extends: DefaultTheme,
  enhanceApp: ({ app }) => void app.component('Live', Live),
};
