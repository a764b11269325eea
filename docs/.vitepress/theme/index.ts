/** VitePress's theme with the fonts and colours of the page, and with live garments. */
import type {Theme} from 'vitepress';
import defaultTheme from 'vitepress/theme-without-fonts';

import './site.css';
import {LiveGarment} from './live-garment.js';

export default {
  extends: defaultTheme,
  enhanceApp({app}) {
    app.component('LiveGarment', LiveGarment);
  },
} satisfies Theme;
