(* The checker is sound, over any ordered field that has the rational numbers in it: what it accepts is true. *)
From Coq Require Import ZArith QArith List Bool Lia Ring Setoid Morphisms.
From Boundfit Require Import Reader Checker Convex.
Import ListNotations.
Local Open Scope Z_scope.

(* An ordered field, as far as it is needed: [nonneg] is 0 <= , [phi] and [q] are where integers and fractions are. *)
Record ordered_field (F : Type) (zero one : F) (add mul sub : F -> F -> F) (neg : F -> F) (eq : F -> F -> Prop)
    (nonneg : F -> Prop) (phi : Z -> F) (q : Q -> F) : Prop := {
  of_equiv : Equivalence eq;
  of_ext : ring_eq_ext add mul neg eq;
  of_ring : ring_theory zero one add mul sub neg eq;
  of_nonneg : forall a b, eq a b -> nonneg a -> nonneg b;
  of_add : forall a b, nonneg a -> nonneg b -> nonneg (add a b);
  of_mul : forall a b, nonneg a -> nonneg b -> nonneg (mul a b);
  of_total : forall a, nonneg a \/ nonneg (neg a);
  of_antisym : forall a, nonneg a -> nonneg (neg a) -> eq a zero;
  of_distinct : ~ eq one zero;
  phi_zero : eq (phi 0) zero;
  phi_one : eq (phi 1) one;
  phi_add : forall a b, eq (phi (a + b)) (add (phi a) (phi b));
  phi_mul : forall a b, eq (phi (a * b)) (mul (phi a) (phi b));
  phi_neg : forall a, eq (phi (- a)) (neg (phi a));
  phi_nonneg : forall a, 0 <= a -> nonneg (phi a);
  phi_inverse : forall a, 0 < a -> exists i, nonneg i /\ eq (mul (phi a) i) one;
  q_spec : forall n d, eq (mul (q (n # d)) (phi (Zpos d))) (phi n) }.

Section Soundness.
  Variables (F : Type) (zero one : F) (add mul sub : F -> F -> F) (neg : F -> F) (eq : F -> F -> Prop)
    (nonneg : F -> Prop) (phi : Z -> F) (q : Q -> F).
  Hypothesis field : ordered_field F zero one add mul sub neg eq nonneg phi q.
  Instance equiv : Equivalence eq := of_equiv _ _ _ _ _ _ _ _ _ _ _ field.
  Let ext := of_ext _ _ _ _ _ _ _ _ _ _ _ field.
  Let ring_facts := of_ring _ _ _ _ _ _ _ _ _ _ _ field.
  Add Ring F_ring : ring_facts (setoid equiv ext).
  Instance add_proper : Proper (eq ==> eq ==> eq) add := Radd_ext ext.
  Instance mul_proper : Proper (eq ==> eq ==> eq) mul := Rmul_ext ext.
  Instance neg_proper : Proper (eq ==> eq) neg := Ropp_ext ext.
  Instance sub_proper : Proper (eq ==> eq ==> eq) sub.
  Proof. intros a b E c d E'. rewrite !(Rsub_def ring_facts), E, E'. reflexivity. Qed.
  Instance nonneg_proper : Proper (eq ==> iff) nonneg.
  Proof. intros a b E; split; apply (of_nonneg _ _ _ _ _ _ _ _ _ _ _ field); [| symmetry]; exact E. Qed.
  Let nonneg_add := of_add _ _ _ _ _ _ _ _ _ _ _ field.
  Let nonneg_mul := of_mul _ _ _ _ _ _ _ _ _ _ _ field.
  Let total := of_total _ _ _ _ _ _ _ _ _ _ _ field.
  Let antisym := of_antisym _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi0 := phi_zero _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi1 := phi_one _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi_plus := phi_add _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi_times := phi_mul _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi_opp := phi_neg _ _ _ _ _ _ _ _ _ _ _ field.
  Let phi_pos := phi_nonneg _ _ _ _ _ _ _ _ _ _ _ field.
  Let inverse := phi_inverse _ _ _ _ _ _ _ _ _ _ _ field.
  Let q_is := q_spec _ _ _ _ _ _ _ _ _ _ _ field.
  Infix "==" := eq (at level 70, no associativity).
  Infix "+'" := add (at level 50, left associativity).
  Infix "*'" := mul (at level 40, left associativity).

  Lemma nonneg_zero : nonneg zero.
  Proof. rewrite <- phi0. apply phi_pos. lia. Qed.

  Lemma cancel_nonneg d a : 0 < d -> nonneg (phi d *' a) -> nonneg a.
  Proof.
    intros H Ha. destruct (inverse d H) as (i & Hi & E).
    assert (a == i *' (phi d *' a)) as -> by ring [E].
    auto.
  Qed.
  Lemma cancel_eq d a b : 0 < d -> phi d *' a == phi d *' b -> a == b.
  Proof.
    intros H E. destruct (inverse d H) as (i & Hi & Ei).
    transitivity (i *' (phi d *' a)); [ring [Ei] |]. rewrite E. ring [Ei].
  Qed.

  Definition le (a b : F) := nonneg (sub b a).
  Definition value (u v : F) (p : F * F) := u *' fst p +' v *' snd p.
  Definition meets (c : form) (p : F * F) :=
    (forall b, low c = Some b -> le (q b) (value (q (first c)) (q (second c)) p)) /\
    (forall b, high c = Some b -> le (value (q (first c)) (q (second c)) p) (q b)).

  (* Half-planes at a point. *)
  Definition val (h : triple) (p : F * F) := phi (tx h) *' fst p +' phi (ty h) *' snd p +' phi (tw h).
  Definition holds h p := nonneg (val h p).
  Ltac push := unfold val, plus, times, opposite, infinity; cbn [tx ty tw];
    repeat (rewrite phi_plus || rewrite phi_times || rewrite phi_opp || rewrite phi0 || rewrite phi1).
  Lemma val_plus a b p : val (plus a b) p == val a p +' val b p.
  Proof. push. ring. Qed.
  Lemma val_times z a p : val (times z a) p == phi z *' val a p.
  Proof. push. ring. Qed.
  Lemma val_opposite a p : val (opposite a) p == neg (val a p).
  Proof. push. ring. Qed.
  Lemma val_infinity p : val infinity p == one.
  Proof. push. ring. Qed.
  Lemma holds_infinity p : holds infinity p.
  Proof. unfold holds. rewrite val_infinity, <- phi1. apply phi_pos. lia. Qed.
  Lemma holds_times z a p : 0 <= z -> holds a p -> holds (times z a) p.
  Proof. unfold holds. intros. rewrite val_times. auto. Qed.
  Lemma holds_plus a b p : holds a p -> holds b p -> holds (plus a b) p.
  Proof. unfold holds. intros. rewrite val_plus. auto. Qed.
  Lemma holds_cancel z a p : 0 < z -> holds (times z a) p -> holds a p.
  Proof. unfold holds. intros Hz. rewrite val_times. now apply cancel_nonneg. Qed.

  (* The half-plane is a multiple of what it says. *)
  Lemma upper_scaled u v b p : exists k, 0 < k /\ val (upper u v b) p == phi k *' sub (q b) (value (q u) (q v) p).
  Proof.
    destruct u as [un ud], v as [vn vd], b as [bn bd].
    pose proof (q_is un ud) as Hu. pose proof (q_is vn vd) as Hv. pose proof (q_is bn bd) as Hb.
    unfold upper, val, value. destruct (ud =? bd)%positive eqn:E; cbn [tx ty tw].
    - apply Pos.eqb_eq in E. subst bd. exists (Zpos ud * Zpos vd). split; [reflexivity |].
      rewrite !phi_opp, !phi_times. ring [Hu Hv Hb].
    - exists (Zpos ud * Zpos vd * Zpos bd). split; [reflexivity |]. rewrite !phi_opp, !phi_times. ring [Hu Hv Hb].
  Qed.
  Lemma upper_is u v b p : holds (upper u v b) p <-> le (value (q u) (q v) p) (q b).
  Proof.
    destruct (upper_scaled u v b p) as (k & Hk & E). unfold holds, le. rewrite E.
    split; [now apply cancel_nonneg | intros; apply nonneg_mul; [apply phi_pos; lia | assumption]].
  Qed.
  Lemma lower_is u v b p : holds (opposite (upper u v b)) p <-> le (q b) (value (q u) (q v) p).
  Proof.
    destruct (upper_scaled u v b p) as (k & Hk & E). unfold holds, le. rewrite val_opposite, E.
    assert (neg (phi k *' sub (q b) (value (q u) (q v) p)) == phi k *' sub (value (q u) (q v) p) (q b)) as -> by ring.
    split; [now apply cancel_nonneg | intros; apply nonneg_mul; [apply phi_pos; lia | assumption]].
  Qed.

  Lemma meets_halves c p : meets c p <-> forall h, In h (halves c) -> holds h p.
  Proof.
    unfold meets, halves. destruct c as [u v lo hi]; cbn. split.
    - intros [L H] h Hin. apply in_app_or in Hin. destruct Hin as [Hin | Hin].
      + destruct lo; [destruct Hin as [<- | []] | destruct Hin]. apply lower_is. auto.
      + destruct hi; [destruct Hin as [<- | []] | destruct Hin]. apply upper_is. auto.
    - intros H. split; intros b ->.
      + apply lower_is, H, in_or_app. cbn. auto.
      + apply upper_is, H, in_or_app. cbn. auto.
  Qed.
  Definition feasible (forms : list form) (p : F * F) := forall c, In c forms -> meets c p.
  Lemma feasible_halves forms p : feasible forms p <-> forall h, In h (flat_map halves forms) -> holds h p.
  Proof.
    split.
    - intros H h Hin. apply in_flat_map in Hin. destruct Hin as (c & Hc & Hh). apply (proj1 (meets_halves c p) (H c Hc)). exact Hh.
    - intros H c Hc. apply meets_halves. intros h Hh. apply H, in_flat_map. eauto.
  Qed.

  (* Numbered half-planes are among those of the table. *)
  Lemma put_all (P : triple -> Prop) h : P h -> forall i t, (forall j g, get j t = Some g -> P g) -> forall j g, get j (put i h t) = Some g -> P g.
  Proof.
    intros Hh.
    assert (none : forall j g, get j Leaf = Some g -> P g) by (intros [] ? ?; discriminate).
    assert (node : forall l v r, (forall j g, get j l = Some g -> P g) -> (forall g, v = Some g -> P g) ->
      (forall j g, get j r = Some g -> P g) -> forall j g, get j (Node l v r) = Some g -> P g).
    { intros l v r Hl Hv Hr [j | j |] g; cbn [get]; eauto. }
    assert (some : forall g, Some h = Some g -> P g) by (intros g E; now injection E as <-).
    assert (no : forall g, None = Some g -> P g) by discriminate.
    induction i as [i IH | i IH |]; intros [| l v r] Ht; cbn [put]; apply node; auto;
      try (intros j g; apply (Ht (xI j))); try (intros j g; apply (Ht (xO j))); try (intros g; apply (Ht xH));
      apply IH; auto; try (intros j g; apply (Ht (xI j))); try (intros j g; apply (Ht (xO j))).
  Qed.
  Lemma table_all (P : triple -> Prop) l : (forall h, In h l -> P h) -> forall i t, (forall j g, get j t = Some g -> P g) ->
    forall j g, get j (table l i t) = Some g -> P g.
  Proof.
    induction l as [| h l IH]; intros Hl i t Ht j g; cbn [table]; [apply Ht |].
    apply IH; [intros; apply Hl; now right |]. apply put_all; [apply Hl; now left | exact Ht].
  Qed.
  Lemma side_holds hs p : (forall h, In h hs -> holds h p) -> forall i, holds (side (table hs 1 Leaf) i) p.
  Proof.
    intros H i. destruct i as [| i | i]; cbn [side]; try apply holds_infinity.
    destruct (get i _) eqn:E; [| apply holds_infinity].
    revert E. apply (table_all (fun h => holds h p)); [exact H |]. intros [] ? ?; discriminate.
  Qed.

  Lemma phi_dot h g : phi (dot h g) == phi (tx h) *' phi (tx g) +' phi (ty h) *' phi (ty g) +' phi (tw h) *' phi (tw g).
  Proof. unfold dot. rewrite !phi_plus, !phi_times. reflexivity. Qed.

  Lemma dot_plus a b g : dot (plus a b) g = dot a g + dot b g.
  Proof. unfold dot, plus. cbn [tx ty tw]. ring. Qed.
  Lemma dot_times z a g : dot (times z a) g = z * dot a g.
  Proof. unfold dot, times. cbn [tx ty tw]. ring. Qed.

  Lemma same_dots a b : (forall u, dot a u = dot b u) -> a = b.
  Proof.
    intros H. pose proof (H (T 1 0 0)) as X. pose proof (H (T 0 1 0)) as Y. pose proof (H (T 0 0 1)) as W.
    destruct a, b. unfold dot in *. cbn in *. f_equal; lia.
  Qed.

  (* Sums of generators: three suffice in the plane. *)
  Definition mixed (gs : list triple) (p : F * F) :=
    exists g1 g2 g3 c1 c2 c3, In g1 gs /\ In g2 gs /\ In g3 gs /\ nonneg c1 /\ nonneg c2 /\ nonneg c3 /\
    fst p == c1 *' phi (tx g1) +' c2 *' phi (tx g2) +' c3 *' phi (tx g3) /\
    snd p == c1 *' phi (ty g1) +' c2 *' phi (ty g2) +' c3 *' phi (ty g3) /\
    one == c1 *' phi (tw g1) +' c2 *' phi (tw g2) +' c3 *' phi (tw g3).

  Lemma mixed_holds gs h p : (forall g, In g gs -> 0 <= dot h g) -> mixed gs p -> holds h p.
  Proof.
    intros H (g1 & g2 & g3 & c1 & c2 & c3 & I1 & I2 & I3 & P1 & P2 & P3 & Ex & Ey & Ew). unfold holds, val.
    assert (E : phi (tx h) *' fst p +' phi (ty h) *' snd p +' phi (tw h) ==
      c1 *' phi (dot h g1) +' c2 *' phi (dot h g2) +' c3 *' phi (dot h g3)).
    { transitivity (phi (tx h) *' fst p +' phi (ty h) *' snd p +' phi (tw h) *' one); [ring |].
      pose proof (phi_dot h g1) as D1. pose proof (phi_dot h g2) as D2. pose proof (phi_dot h g3) as D3.
      rewrite Ew. ring [Ex Ey D1 D2 D3]. }
    rewrite E. auto 10.
  Qed.

  Lemma mixed_incl gs gs' p : (forall g, In g gs -> In g gs') -> mixed gs p -> mixed gs' p.
  Proof.
    intros H (g1 & g2 & g3 & c1 & c2 & c3 & I1 & I2 & I3 & R).
    exists g1, g2, g3, c1, c2, c3. do 3 (split; [auto |]). exact R.
  Qed.

  (* A mixture is one of every half-plane's values, so three half-planes have the coordinates. *)
  Lemma mixed_of_values gs g1 g2 g3 c1 c2 c3 p : In g1 gs -> In g2 gs -> In g3 gs -> nonneg c1 -> nonneg c2 -> nonneg c3 ->
    (forall e, val e p == c1 *' phi (dot e g1) +' c2 *' phi (dot e g2) +' c3 *' phi (dot e g3)) -> mixed gs p.
  Proof.
    intros I1 I2 I3 P1 P2 P3 R. exists g1, g2, g3, c1, c2, c3. do 6 (split; [assumption |]).
    assert (Dx : forall g, dot (T 1 0 0) g = tx g) by (intros; unfold dot; cbn [tx ty tw]; ring).
    assert (Dy : forall g, dot (T 0 1 0) g = ty g) by (intros; unfold dot; cbn [tx ty tw]; ring).
    assert (Dw : forall g, dot (T 0 0 1) g = tw g) by (intros; unfold dot; cbn [tx ty tw]; ring).
    rewrite <- !Dx, <- !Dy, <- !Dw, <- !R. unfold val. cbn [tx ty tw]. repeat split; ring [phi0 phi1].
  Qed.

  (* A half-plane is a sum of the lines through two of three points each. *)
  Lemma by_crosses a b c e :
    plus (times (dot e a) (cross b c)) (plus (times (dot e b) (cross c a)) (times (dot e c) (cross a b))) = times (det a b c) e.
  Proof.
    apply same_dots. intros u. rewrite !dot_plus, !dot_times, rotated. change (dot (cross a b) u) with (det a b u).
    change (dot (cross c a) u) with (det c a u). rewrite (cramer e a b c u), (turned c a u). ring.
  Qed.

  Lemma in_triangle gs a b c p : In a gs -> In b gs -> In c gs -> 0 < det a b c ->
    holds (cross b c) p -> holds (cross c a) p -> holds (cross a b) p -> mixed gs p.
  Proof.
    intros Ia Ib Ic HD Ha Hb Hc. destruct (inverse _ HD) as (i & Hi & Ei).
    apply (mixed_of_values gs a b c (i *' val (cross b c) p) (i *' val (cross c a) p) (i *' val (cross a b) p));
      try assumption; try (now apply nonneg_mul).
    intros e. transitivity (i *' (phi (det a b c) *' val e p)).
    - transitivity ((phi (det a b c) *' i) *' val e p); [rewrite Ei |]; ring.
    - rewrite <- val_times, <- by_crosses, !val_plus, !val_times. ring.
  Qed.

  (* A side through a and b with c inside, as the line through them. *)
  Lemma edge_holds s a b c p : dot s a = 0 -> dot s b = 0 -> 0 < dot s c -> 0 < det a b c -> holds s p -> holds (cross a b) p.
  Proof.
    intros Ha Hb Hc HD H. apply (holds_cancel (dot s c)); [assumption |].
    replace (times (dot s c) (cross a b)) with (times (det a b c) s); [apply holds_times; [lia | exact H] |].
    rewrite <- by_crosses, Ha, Hb. unfold plus, times. cbn [tx ty tw]. f_equal; ring.
  Qed.

  Lemma fan_covers g0 : forall rest sides q0 r gs p, cover g0 q0 r rest sides = true ->
    In g0 gs -> In r gs -> (forall g, In g rest -> In g gs) ->
    (forall h, In h sides -> holds h p) -> (rest = [] -> 0 < det g0 q0 r) -> holds (cross g0 r) p ->
    (rest = [] -> mixed gs p) -> mixed gs p.
  Proof.
    induction rest as [| s rest IH]; intros sides q0 r gs p H I0 Ir Irest Hs Hd Hr Hbase; [now apply Hbase |].
    destruct sides as [| h sides]; cbn [cover] in H; try discriminate. split_checks.
    assert (Hh : holds h p) by (apply Hs; now left).
    assert (Erot : det r s g0 = det g0 r s) by (open_triples; ring).
    assert (Hedge : holds (cross r s) p) by (apply (edge_holds h r s g0); auto; lia).
    assert (In s gs) by (apply Irest; now left).
    destruct (total (val (cross g0 s) p)) as [Hpos | Hneg].
    - apply (IH sides r s gs p); auto.
      + intros; apply Irest; now right.
      + intros; apply Hs; now right.
      + intros ->. destruct sides as [| last [| ? ?]]; cbn [cover] in *; try discriminate. split_checks.
        (* the last side turns p back into the last triangle *)
        apply (in_triangle gs g0 r s); auto.
        apply (edge_holds last s g0 r); auto; [| apply Hs; cbn; auto].
        replace (det s g0 r) with (det g0 r s) by (open_triples; ring). assumption.
    - apply (in_triangle gs g0 r s); auto.
      unfold holds. rewrite <- val_opposite in Hneg.
      replace (cross s g0) with (opposite (cross g0 s)) by (open_triples; f_equal; ring). exact Hneg.
  Qed.
  Theorem covered gs sides p : cover_of gs sides = true -> (forall h, In h sides -> holds h p) -> mixed gs p.
  Proof.
    intros H Hs. destruct gs as [| g0 [| g1 [| g2 rest]]]; try discriminate. destruct sides as [| h0 sides]; try discriminate.
    cbn [cover_of] in H. split_checks.
    assert (0 < det g0 g1 g2).
    { match goal with H : cover _ _ _ _ _ = true |- _ => destruct sides; cbn [cover] in H; [discriminate |] end. now split_checks. }
    eapply (fan_covers g0 (g2 :: rest) sides g0 g1); eauto; try (cbn; auto; fail); try discriminate.
    - intros; apply Hs; now right.
    - apply (edge_holds h0 g0 g1 g2); auto. apply Hs; now left.
  Qed.
  Lemma fan_is_cover g0 n : forall rest sides q0 r, fan g0 n q0 r rest sides = true -> cover g0 q0 r rest sides = true.
  Proof.
    induction rest as [| s rest IH]; intros [| h sides] q0 r; cbn [fan cover]; auto; intros H; try discriminate.
    cbv zeta in H. rewrite !rotated in H. split_checks. rewrite IH by assumption. rewrite !andb_true_iff. repeat split; try apply Z.ltb_lt; try apply Z.eqb_eq; auto.
  Qed.
  Lemma fan_covered gs sides : fan_of gs sides = true -> cover_of gs sides = true.
  Proof.
    destruct gs as [| g0 [| g1 [| g2 rest]]]; try discriminate. destruct sides as [| h0 sides]; try discriminate.
    unfold fan_of, cover_of. intros H. split_checks. rewrite (fan_is_cover g0 (cross g0 g1)) by assumption.
    rewrite !andb_true_iff. repeat split; try apply Z.ltb_lt; try apply Z.eqb_eq; auto.
  Qed.

  (* A half-plane whose normal lies between those of two sides at their vertex. *)
  Lemma turns_is a b : turns a b = (tx a * ty b ?= ty a * tx b).
  Proof.
    unfold turns. destruct (ty a =? ty b) eqn:E; [| reflexivity]. apply Z.eqb_eq in E. rewrite <- E.
    destruct (ty a) as [| d | d] eqn:Ed.
    - rewrite Z.mul_0_r. now cbn.
    - destruct (Z.compare_spec (tx a) (tx b)); symmetry; rewrite ?Z.compare_eq_iff, ?Z.compare_lt_iff, ?Z.compare_gt_iff; nia.
    - destruct (Z.compare_spec (tx b) (tx a)); symmetry; rewrite ?Z.compare_eq_iff, ?Z.compare_lt_iff, ?Z.compare_gt_iff; nia.
  Qed.
  Lemma not_right_is a b : not_right a b = true -> 0 <= turn a b.
  Proof. unfold not_right. rewrite turns_is. unfold turn. destruct (Z.compare_spec (tx a * ty b) (ty a * tx b)); intros; try discriminate; lia. Qed.
  Lemma enclosed_sum c h : is_corner c = true -> enclosed c h = true ->
    exists k l m n, 0 < k /\ 0 <= l /\ 0 <= m /\ 0 <= n /\
    times k h = plus (times l (before c)) (plus (times m (after c)) (times n infinity)).
  Proof.
    destruct c as [s v s']. unfold is_corner, enclosed. cbn [before at_ after]. intros. split_checks.
    repeat match goal with H : not_right _ _ = true |- _ => apply not_right_is in H end.
    exists (turn s s' * tw v), (turn h s' * tw v), (turn s h * tw v), (turn s s' * dot h v).
    split; [nia |]. do 3 (split; [nia |]).
    assert (E : forall a b c : Z, a = 0 -> b = 0 -> forall x y, c = x * a + y * b -> c = 0) by (intros; subst; ring).
    destruct s as [a b c], s' as [a' b' c'], h as [A B C], v as [X Y W]. open_triples. f_equal; try ring.
    (* the constant: each side is 0 at the vertex *)
    apply Zminus_eq. apply (E (a * X + b * Y + c * W) (a' * X + b' * Y + c' * W)) with (x := - (A * b' - B * a')) (y := - (a * B - b * A)); auto. ring.
  Qed.
  Lemma enclosed_holds c h p : is_corner c = true -> enclosed c h = true -> holds (before c) p -> holds (after c) p -> holds h p.
  Proof.
    intros Hc He Hb Ha. destruct (enclosed_sum c h Hc He) as (k & l & m & n & Hk & Hl & Hm & Hn & E).
    apply (holds_cancel k); [assumption |]. rewrite E.
    apply holds_plus; [now apply holds_times |]. apply holds_plus; apply holds_times; auto. apply holds_infinity.
  Qed.
  Lemma enclosed_dot c h g : is_corner c = true -> enclosed c h = true -> 0 <= tw g -> 0 <= dot (before c) g -> 0 <= dot (after c) g -> 0 <= dot h g.
  Proof.
    intros Hc He Hw Hb Ha. destruct (enclosed_sum c h Hc He) as (k & l & m & n & Hk & Hl & Hm & Hn & E).
    apply (cancel k); [assumption |].
    rewrite <- dot_times, E, !dot_plus, !dot_times.
    assert (dot infinity g = tw g) as -> by (unfold dot, infinity; cbn [tx ty tw]; ring). nia.
  Qed.

  (* What is found is one of the corners. *)
  Lemma build_all (P : corner -> Prop) base : forall depth l, (forall c, In c l -> P c) ->
    (forall best h late, P best -> P (seek h late (fst (build base depth l)) best)) /\ (forall c, In c (snd (build base depth l)) -> P c).
  Proof.
    induction depth as [| depth IH]; intros l Hl; cbn [build]; [cbn; auto |].
    destruct (build base depth l) as [a l1] eqn:E1. destruct (IH l Hl) as [Fa R1]. rewrite E1 in *. cbn [fst snd] in *.
    destruct l1 as [| c l1]; [cbn; auto |].
    destruct (build base depth l1) as [b l2] eqn:E2.
    destruct (IH l1) as [Fb R2]; [intros; apply R1; now right |]. rewrite E2 in *. cbn [fst snd] in *.
    split; [| exact R2]. intros best h late Hbest. cbn [seek].
    destruct (if eqb late _ then _ else _); [apply Fb, R1; now left | now apply Fa].
  Qed.

  Lemma corners_from_sides : forall gs sides h c, In c (corners_from h gs sides) ->
    (before c = h \/ In (before c) sides) /\ In (after c) sides.
  Proof.
    induction gs as [| g gs IH]; intros [| s sides] h c H; cbn [corners_from] in H; try contradiction.
    assert (In c (corners_from s gs sides) -> (before c = h \/ In (before c) (s :: sides)) /\ In (after c) (s :: sides)).
    { intros H'. apply IH in H'. destruct H' as [[-> | ?] ?]; cbn; auto. }
    destruct (0 <? tw g); [destruct H as [<- | H] |]; cbn; auto.
  Qed.
  Lemma corners_sides gs sides c : In c (corners gs sides) -> In (before c) sides /\ In (after c) sides.
  Proof.
    destruct gs as [| g0 gs], sides as [| h0 sides]; cbn [corners]; try contradiction.
    intros H. apply corners_from_sides in H.
    assert (A : forall h, In h (sides ++ [h0]) -> In h (h0 :: sides)).
    { intros h Hh. apply in_app_or in Hh. destruct Hh as [Hh | [<- | []]]; [now right | now left]. }
    destruct H as [[-> | Hb] Ha]; split; auto; now left.
  Qed.

  Lemma polygon_sound hs gs sides : check_polygon hs gs sides = true -> (forall g, In g gs -> 0 <= tw g) ->
    (forall p, (forall h, In h sides -> holds h p) -> mixed gs p) /\ (forall h g, In h hs -> In g gs -> 0 <= dot h g).
  Proof.
    unfold check_polygon. intros H Hw. destruct (corners gs sides) as [| c0 cs] eqn:E; [discriminate |].
    apply andb_prop in H. destruct H as [H Hall]. apply andb_prop in H. destruct H as [Hfan Hcs].
    rewrite forallb_forall in Hall. rewrite forallb_forall in Hcs.
    split; [intros p Hp; apply covered with sides; auto using fan_covered |].
    intros h g Hh Hg. pose proof (Hall h Hh) as He.
    set (found := seek h _ _ c0) in *.
    assert (Hin : In found (c0 :: cs)).
    { apply (proj1 (build_all (fun c => In c (c0 :: cs)) (before c0) 40 (c0 :: cs) (fun c H => H))). now left. }
    pose proof Hin as Hs. rewrite <- E in Hs. apply corners_sides in Hs. destruct Hs as [Hb Ha].
    apply (enclosed_dot found); auto.
    - apply (sides_keep gs sides Hfan); auto.
    - apply (sides_keep gs sides Hfan); auto.
  Qed.

  (* Sets on a line. *)
  (* A half-plane is a sum of a part along n and one across it. *)
  Lemma along_and_across n a : times (dot n n) a = plus (times (dot a n) n) (cross n (cross a n)).
  Proof. destruct a, n. open_triples. f_equal; ring. Qed.
  Lemma parallel_is a n : parallel a n = true -> times (dot n n) a = times (dot a n) n.
  Proof.
    unfold parallel. intros H. split_checks.
    rewrite (along_and_across n a). destruct (cross a n) as [x y z]. cbn [tx ty tw] in *. subst.
    unfold plus, times, cross. cbn [tx ty tw]. f_equal; ring.
  Qed.
  Lemma on_line_zero g1 g2 h h' p : on_line g1 g2 h h' = true -> holds h p -> holds h' p ->
    val (cross g1 g2) p == zero /\ 0 < dot (cross g1 g2) (cross g1 g2).
  Proof.
    unfold on_line. cbv zeta. set (n := cross g1 g2). intros H Hh Hh'. split_checks.
    repeat match goal with H : parallel _ _ = true |- _ => apply parallel_is in H end.
    assert (0 < dot n n).
    { destruct n as [x y z]. unfold dot in *. cbn [tx ty tw] in *. destruct (Z.eq_dec x 0), (Z.eq_dec y 0), (Z.eq_dec z 0); subst; nia. }
    split; [| assumption].
    apply antisym.
    - apply (holds_cancel (dot h n)); [assumption |]. rewrite <- H. apply holds_times; [lia | exact Hh].
    - rewrite <- val_opposite. apply (holds_cancel (- dot h' n)); [lia |].
      replace (times (- dot h' n) (opposite n)) with (times (dot h' n) n) by (unfold times, opposite; cbn [tx ty tw]; f_equal; ring).
      match goal with E : _ = times (dot h' n) n |- _ => rewrite <- E end. apply holds_times; [lia | exact Hh'].
  Qed.
  Lemma on_line_form g1 g2 c p : val (cross g1 g2) p == zero -> 0 < dot (cross g1 g2) (cross g1 g2) -> dot c g1 = 0 -> dot c g2 = 0 -> val c p == zero.
  Proof.
    intros Hz Hn H1 H2. apply (cancel_eq _ _ _ Hn). rewrite <- val_times.
    assert (cross c (cross g1 g2) = plus (times (dot c g2) g1) (times (- dot c g1) g2)) as E.
    { destruct c. open_triples. f_equal; ring. }
    rewrite along_and_across, E.
    rewrite H1, H2, val_plus, val_times, Hz.
    assert (forall n, cross n (plus (times 0 g1) (times (- 0) g2)) = times 0 infinity) as -> by (intros; open_triples; f_equal; ring).
    rewrite val_times, phi0. ring.
  Qed.
  Lemma between_mixed gs g1 g2 e1 e2 p : In g1 gs -> In g2 gs -> between g1 g2 e1 e2 = true ->
    val (cross g1 g2) p == zero -> 0 < dot (cross g1 g2) (cross g1 g2) -> holds e1 p -> holds e2 p -> mixed gs p.
  Proof.
    unfold between. intros I1 I2 H Hz Hn H1 H2. split_checks.
    match goal with A : 0 < dot e2 g1, B : 0 < dot e1 g2 |- _ => rename A into P1; rename B into P2 end.
    destruct (inverse _ P1) as (i & Hi & Ei). destruct (inverse _ P2) as (j & Hj & Ej).
    apply (mixed_of_values gs g1 g2 g2 (i *' val e2 p) (j *' val e1 p) zero); try assumption; try (now apply nonneg_mul);
      try apply nonneg_zero. intros e.
    set (d1 := dot e2 g1) in *. set (d2 := dot e1 g2) in *.
    assert (C : val (plus (times (d1 * d2) e) (plus (times (- (d2 * dot e g1)) e2) (times (- (d1 * dot e g2)) e1))) p == zero).
    { apply (on_line_form g1 g2); auto.
      - rewrite !dot_plus, !dot_times. fold d1. rewrite H. ring.
      - rewrite !dot_plus, !dot_times. fold d2. match goal with E : dot e2 g2 = 0 |- _ => rewrite E end. ring. }
    rewrite !val_plus, !val_times, !phi_opp, !phi_times in C.
    apply (cancel_eq d1); [assumption |]. apply (cancel_eq d2); [assumption |].
    set (v := val e p) in *. set (v1 := val e1 p) in *. set (v2 := val e2 p) in *.
    set (f1 := phi (dot e g1)) in *. set (f2 := phi (dot e g2)) in *.
    transitivity (phi d1 *' phi d2 *' v +' neg (phi d1 *' phi d2 *' v +' (neg (phi d2 *' f1) *' v2 +' neg (phi d1 *' f2) *' v1)));
      [rewrite C; ring |].
    transitivity (phi d2 *' f1 *' (phi d1 *' i) *' v2 +' phi d1 *' f2 *' (phi d2 *' j) *' v1); [rewrite Ei, Ej |]; ring.
  Qed.

  (* A point. *)
  Lemma pairs_in h0 : forall l s, In s (pairs h0 l) -> (In (fst s) l) /\ (snd s = h0 \/ In (snd s) l).
  Proof.
    induction l as [| h l IH]; cbn [pairs]; [contradiction |].
    destruct l as [| h' l]; intros s [<- | H]; cbn; auto; try contradiction.
    apply IH in H. destruct H as [Ha [Hb | Hb]]; split; auto; now right.
  Qed.
  Lemma equal a b : nonneg (sub a b) -> nonneg (sub b a) -> a == b.
  Proof.
    intros L G. assert (E : neg (sub a b) == sub b a) by ring. rewrite <- E in G. pose proof (antisym _ L G) as Z.
    transitivity (sub a b +' b); [ring | rewrite Z; ring].
  Qed.
  Lemma pinned_mixed v sides p : pinned v sides = true -> 0 < tw v -> (forall h, In h sides -> holds h p) -> mixed [v] p.
  Proof.
    intros H Hw Hs. destruct sides as [| h0 sides]; [discriminate |]. cbn [pinned] in H.
    assert (A : forall h, existsb (fun s => is_corner (Corner (fst s) v (snd s)) && enclosed (Corner (fst s) v (snd s)) h) (pairs h0 (h0 :: sides)) = true -> holds h p).
    { intros h E. apply existsb_exists in E. destruct E as (s & Hin & E). split_checks. apply pairs_in in Hin.
      destruct Hin as [Ha Hb]. apply (enclosed_holds (Corner (fst s) v (snd s))); auto; cbn; apply Hs; auto.
      destruct Hb as [-> | Hb]; [now left | exact Hb]. }
    split_checks. repeat match goal with H : existsb _ _ = true |- _ => apply A in H end.
    destruct (inverse _ Hw) as (i & Hi & Ei).
    assert (Ex : phi (tw v) *' fst p == phi (tx v)).
    { apply equal; [refine (of_nonneg _ _ _ _ _ _ _ _ _ _ _ field _ _ _ H) | refine (of_nonneg _ _ _ _ _ _ _ _ _ _ _ field _ _ _ H2)];
        unfold val; cbn [tx ty tw]; ring [phi0 (phi_opp (tx v)) (phi_opp (tw v))]. }
    assert (Ey : phi (tw v) *' snd p == phi (ty v)).
    { apply equal; [refine (of_nonneg _ _ _ _ _ _ _ _ _ _ _ field _ _ _ H1) | refine (of_nonneg _ _ _ _ _ _ _ _ _ _ _ field _ _ _ H0)];
        unfold val; cbn [tx ty tw]; ring [phi0 (phi_opp (ty v)) (phi_opp (tw v))]. }
    exists v, v, v, i, zero, zero. do 3 (split; [now left |]). split; [assumption |]. do 2 (split; [apply nonneg_zero |]).
    repeat split.
    - rewrite <- Ex. ring [Ei].
    - rewrite <- Ey. ring [Ei].
    - ring [Ei].
  Qed.

  (* The whole plane. *)
  Lemma everything_mixed p : mixed [T 0 0 1; T 1 0 0; T (-1) 0 0; T 0 1 0; T 0 (-1) 0] p.
  Proof.
    assert (S : forall a, exists c s, nonneg c /\ (s = 1 \/ s = -1) /\ a == c *' phi s).
    { intros a. destruct (total a) as [H | H].
      - exists a, 1. repeat split; auto. rewrite phi1. ring.
      - exists (neg a), (-1). repeat split; auto. change (-1) with (- (1)). rewrite phi_opp, phi1. ring. }
    destruct (S (fst p)) as (c & s & Hc & Hs & Ec). destruct (S (snd p)) as (d & t & Hd & Ht & Ed).
    exists (T 0 0 1), (T s 0 0), (T 0 t 0), one, c, d.
    split; [now left |]. split; [destruct Hs; subst; cbn; auto 8 |]. split; [destruct Ht; subst; cbn; auto 8 |].
    split; [rewrite <- phi1; apply phi_pos; lia |]. split; [assumption |]. split; [assumption |]. cbn [tx ty tw].
    repeat split.
    - rewrite Ec at 1. rewrite phi0. ring.
    - rewrite Ed at 1. rewrite phi0. ring.
    - rewrite phi0, phi1. ring.
  Qed.

  (* Every certificate. *)
  Lemma is_same_is a b : is_same a b = true -> a = b.
  Proof. destruct a as [x y w], b as [x' y' w']. unfold is_same. cbn [tx ty tw]. intros. split_checks. now subst. Qed.
  Lemma all_hold_is hs gs : all_hold hs gs = true -> forall h g, In h hs -> In g gs -> 0 <= dot h g.
  Proof. unfold all_hold. rewrite forallb_forall. intros H h g Hh Hg. specialize (H h Hh). rewrite forallb_forall in H. apply Z.leb_le. auto. Qed.
  Lemma vertex_positive v : 0 < tw (vertex v).
  Proof. destruct v as [[xn xd] [yn yd]]. unfold vertex. destruct (xd =? yd)%positive; reflexivity. Qed.
  Lemma ray_zero r : tw (ray r) = 0.
  Proof. destruct r as [[xn xd] [yn yd]]. reflexivity. Qed.

  Theorem generators_sound forms cert vertices rays : check forms cert vertices rays = true ->
    let gs := map vertex vertices ++ map ray rays in
    (forall p, feasible forms p <-> mixed gs p) /\ (forall h g, In h (flat_map halves forms) -> In g gs -> 0 <= dot h g).
  Proof.
    intros H gs.
    assert (Hw : forall g, In g gs -> 0 <= tw g).
    { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg | Hg]; apply in_map_iff in Hg; destruct Hg as (x & <- & _).
      - pose proof (vertex_positive x). lia.
      - rewrite ray_zero. lia. }
    assert (Hvw : forall v, In v (map vertex vertices) -> 0 < tw v).
    { intros v Hv. apply in_map_iff in Hv. destruct Hv as (x & <- & _). apply vertex_positive. }
    set (hs := flat_map halves forms) in *.
    assert (Main : (forall p, (forall h, In h hs -> holds h p) -> mixed gs p) -> (forall h g, In h hs -> In g gs -> 0 <= dot h g) ->
      (forall p, feasible forms p <-> mixed gs p) /\ (forall h g, In h hs -> In g gs -> 0 <= dot h g)).
    { intros Hin Hdot. split; [| exact Hdot]. intros p. rewrite feasible_halves. fold hs. split; [apply Hin |].
      intros Hm h Hh. apply (mixed_holds gs); auto. }
    unfold check in H. fold hs in H. subst gs.
    destruct (map vertex vertices) as [| v vs]; [destruct cert; discriminate |].
    set (rs := map ray rays) in *. set (t := table hs 1 Leaf) in *.
    assert (Side : forall p, (forall h, In h hs -> holds h p) -> forall i, holds (side t i) p) by (intros; now apply side_holds).
    assert (Sides : forall p l, (forall h, In h hs -> holds h p) -> forall h, In h (map (side t) l) -> holds h p).
    { intros p l Hp h Hh. apply in_map_iff in Hh. destruct Hh as (i & <- & _). auto. }
    destruct cert as [sides | sides | s | h h' e1 e2 | h h' e | h h' | sides |].
    - (* polygon *)
      split_checks. rename H0 into Hc.
      assert (Harr : forall g, In g (arranged (v :: vs) rs) <-> In g ((v :: vs) ++ rs)).
      { intros g. unfold arranged. destruct rs as [| r [| r' [| r'' rs']]]; cbn [length] in H.
        - now rewrite app_nil_r.
        - split; intros I.
          + destruct I as [<- | I]; apply in_or_app; [right; now left | now left].
          + apply in_app_or in I. destruct I as [I | [<- | []]]; [now right | now left].
        - split; intros I.
          + destruct I as [<- | I]; apply in_or_app; [right; now left |].
            apply in_app_or in I. destruct I as [I | [<- | []]]; [now left | right; right; now left].
          + apply in_app_or in I. destruct I as [I | [<- | [<- | []]]].
            * right. apply in_or_app. now left.
            * now left.
            * right. apply in_or_app. right. now left.
        - exfalso. rewrite !Nat2Z.inj_succ in H. lia. }
      apply polygon_sound in Hc; [| intros; apply Hw; now apply Harr]. destruct Hc as [Hin Hdot].
      apply Main.
      + intros p Hp. apply (mixed_incl (arranged (v :: vs) rs)); [apply Harr |]. apply Hin. now apply Sides.
      + intros; apply Hdot; auto. now apply Harr.
    - (* strip *)
      destruct vs as [| w [|]]; try discriminate. destruct rs as [| r [| r' [|]]]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      apply (mixed_incl [v; r; w; r']); [intros g [<- | [<- | [<- | [<- | []]]]]; simpl; auto |]. apply covered with (map (side t) sides); [assumption |]. now apply Sides.
    - (* half-plane *)
      destruct vs as [|]; try discriminate. destruct rs as [| r [| n [| r' [|]]]]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      apply (mixed_incl [v; r; n; r']); [intros g [<- | [<- | [<- | [<- | []]]]]; simpl; auto |]. eapply covered; [eassumption |].
      intros h [<- | [<- | [<- | [<- | []]]]]; auto using holds_infinity.
    - (* segment *)
      destruct vs as [| w [|]]; try discriminate. destruct rs as [|]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      destruct (on_line_zero v w _ _ p H (Side p Hp _) (Side p Hp _)) as [Hz Hn].
      eapply between_mixed with (g1 := v) (g2 := w); eauto; cbn; auto.
    - (* ray *)
      destruct vs as [|]; try discriminate. destruct rs as [| r [|]]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      destruct (on_line_zero v r _ _ p H (Side p Hp _) (Side p Hp _)) as [Hz Hn].
      eapply between_mixed with (g1 := v) (g2 := r); eauto using holds_infinity; cbn; auto.
    - (* line *)
      destruct vs as [|]; try discriminate. destruct rs as [| r [| r' [|]]]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      destruct (total (val (across v r) p)) as [E | E].
      + destruct (on_line_zero v r _ _ p H (Side p Hp _) (Side p Hp _)) as [Hz Hn].
        eapply between_mixed with (g1 := v) (g2 := r); eauto using holds_infinity; cbn; auto.
      + rewrite <- val_opposite in E.
        match goal with H : on_line v r' _ _ = true |- _ => destruct (on_line_zero v r' _ _ p H (Side p Hp _) (Side p Hp _)) as [Hz Hn] end.
        eapply between_mixed with (g1 := v) (g2 := r'); eauto using holds_infinity; cbn; auto.
    - (* point *)
      destruct vs as [|]; try discriminate. destruct rs as [|]; try discriminate. split_checks.
      apply Main; [| now apply all_hold_is]. intros p Hp.
      eapply pinned_mixed; eauto; apply Hvw; now left.
    - (* everything *)
      destruct vs as [|]; try discriminate. destruct rs as [| r1 [| r2 [| r3 [| r4 [|]]]]]; try discriminate. split_checks.
      repeat match goal with H : is_same _ _ = true |- _ => apply is_same_is in H; subst end.
      apply Main; [| now apply all_hold_is]. intros p _. apply everything_mixed.
  Qed.

  (* A mixture of three vertices; a sum of multiples of three rays; both together. *)
  Definition hull (vs : list (Q * Q)) (p : F * F) :=
    exists a b c, In a vs /\ In b vs /\ In c vs /\
    exists l m n, nonneg l /\ nonneg m /\ nonneg n /\ l +' m +' n == one /\
    fst p == l *' q (fst a) +' m *' q (fst b) +' n *' q (fst c) /\
    snd p == l *' q (snd a) +' m *' q (snd b) +' n *' q (snd c).
  Definition cone (rs : list (Q * Q)) (p : F * F) :=
    exists a b c, In a rs /\ In b rs /\ In c rs /\
    exists l m n, nonneg l /\ nonneg m /\ nonneg n /\
    fst p == l *' q (fst a) +' m *' q (fst b) +' n *' q (fst c) /\
    snd p == l *' q (snd a) +' m *' q (snd b) +' n *' q (snd c).
  Definition hull_and_cone (vs rs : list (Q * Q)) (p : F * F) :=
    exists v r, hull vs v /\ cone rs r /\ fst p == fst v +' fst r /\ snd p == snd v +' snd r.

  Lemma vertex_is v : phi (tx (vertex v)) == phi (tw (vertex v)) *' q (fst v) /\ phi (ty (vertex v)) == phi (tw (vertex v)) *' q (snd v).
  Proof.
    destruct v as [[xn xd] [yn yd]]. unfold vertex. cbn [fst snd].
    pose proof (q_is xn xd) as Hx. pose proof (q_is yn yd) as Hy.
    destruct (xd =? yd)%positive eqn:E; cbn [tx ty tw].
    - apply Pos.eqb_eq in E. subst yd. rewrite <- Hx, <- Hy. split; ring.
    - rewrite !phi_times, <- Hx, <- Hy. split; ring.
  Qed.
  Lemma ray_is r : exists s, 0 < s /\ phi (tx (ray r)) == phi s *' q (fst r) /\ phi (ty (ray r)) == phi s *' q (snd r).
  Proof.
    destruct r as [[xn xd] [yn yd]]. exists (Zpos xd * Zpos yd). split; [reflexivity |]. unfold ray. cbn [fst snd tx ty tw].
    pose proof (q_is xn xd) as Hx. pose proof (q_is yn yd) as Hy.
    rewrite !phi_times, <- Hx, <- Hy. split; ring.
  Qed.

  Lemma mixed_hull vs p : mixed (map vertex vs) p -> hull vs p.
  Proof.
    intros (g1 & g2 & g3 & c1 & c2 & c3 & I1 & I2 & I3 & P1 & P2 & P3 & Ex & Ey & Ew).
    apply in_map_iff in I1, I2, I3. destruct I1 as (a & <- & I1), I2 as (b & <- & I2), I3 as (c & <- & I3).
    pose proof (vertex_positive a). pose proof (vertex_positive b). pose proof (vertex_positive c).
    exists a, b, c. do 3 (split; [assumption |]).
    exists (c1 *' phi (tw (vertex a))), (c2 *' phi (tw (vertex b))), (c3 *' phi (tw (vertex c))).
    do 3 (split; [apply nonneg_mul; [assumption | apply phi_pos; lia] |]). split; [symmetry; exact Ew |].
    destruct (vertex_is a) as [ax ay], (vertex_is b) as [bx byy], (vertex_is c) as [cx cy].
    split; [ring [Ex ax bx cx] | ring [Ey ay byy cy]].
  Qed.

  (* Each generator as a vertex and a ray, of which one is taken no times. *)
  Lemma generator_is vs rs v0 r0 g : In v0 vs -> In r0 rs -> In g (map vertex vs ++ map ray rs) ->
    exists v r a b, In v vs /\ In r rs /\ nonneg a /\ nonneg b /\ phi (tw g) == a /\
    phi (tx g) == a *' q (fst v) +' b *' q (fst r) /\ phi (ty g) == a *' q (snd v) +' b *' q (snd r).
  Proof.
    intros Hv Hr H. apply in_app_or in H. destruct H as [H | H]; apply in_map_iff in H; destruct H as (x & <- & H).
    - destruct (vertex_is x) as [Ex Ey]. pose proof (vertex_positive x).
      exists x, r0, (phi (tw (vertex x))), zero. do 2 (split; [assumption |]). split; [apply phi_pos; lia |].
      split; [apply nonneg_zero |]. split; [reflexivity |]. rewrite Ex, Ey. split; ring.
    - destruct (ray_is x) as (s & Hs & Ex & Ey).
      exists v0, x, zero, (phi s). do 2 (split; [assumption |]). split; [apply nonneg_zero |].
      split; [apply phi_pos; lia |]. split; [now rewrite ray_zero |]. rewrite Ex, Ey. split; ring.
  Qed.
  Lemma mixed_hull_and_cone vs rs v0 r0 p : In v0 vs -> In r0 rs -> mixed (map vertex vs ++ map ray rs) p -> hull_and_cone vs rs p.
  Proof.
    intros Hv Hr (g1 & g2 & g3 & c1 & c2 & c3 & I1 & I2 & I3 & P1 & P2 & P3 & Ex & Ey & Ew).
    destruct (generator_is vs rs v0 r0 g1 Hv Hr I1) as (u1 & r1 & a1 & b1 & Iu1 & Ir1 & A1 & B1 & W1 & X1 & Y1).
    destruct (generator_is vs rs v0 r0 g2 Hv Hr I2) as (u2 & r2 & a2 & b2 & Iu2 & Ir2 & A2 & B2 & W2 & X2 & Y2).
    destruct (generator_is vs rs v0 r0 g3 Hv Hr I3) as (u3 & r3 & a3 & b3 & Iu3 & Ir3 & A3 & B3 & W3 & X3 & Y3).
    exists (c1 *' a1 *' q (fst u1) +' c2 *' a2 *' q (fst u2) +' c3 *' a3 *' q (fst u3),
      c1 *' a1 *' q (snd u1) +' c2 *' a2 *' q (snd u2) +' c3 *' a3 *' q (snd u3)).
    exists (c1 *' b1 *' q (fst r1) +' c2 *' b2 *' q (fst r2) +' c3 *' b3 *' q (fst r3),
      c1 *' b1 *' q (snd r1) +' c2 *' b2 *' q (snd r2) +' c3 *' b3 *' q (snd r3)).
    cbn [fst snd]. split; [| split; [| split]].
    - exists u1, u2, u3. do 3 (split; [assumption |]). exists (c1 *' a1), (c2 *' a2), (c3 *' a3).
      do 3 (split; [now apply nonneg_mul |]). split; [rewrite Ew, W1, W2, W3; reflexivity |]. split; reflexivity.
    - exists r1, r2, r3. do 3 (split; [assumption |]). exists (c1 *' b1), (c2 *' b2), (c3 *' b3).
      do 3 (split; [now apply nonneg_mul |]). split; reflexivity.
    - ring [Ex X1 X2 X3].
    - ring [Ey Y1 Y2 Y3].
  Qed.

  Lemma vertex_holds h v : 0 <= dot h (vertex v) -> holds h (q (fst v), q (snd v)).
  Proof.
    intros H. pose proof (vertex_positive v) as Hw. destruct (vertex_is v) as [Ex Ey]. unfold holds.
    apply (cancel_nonneg _ _ Hw).
    assert (E : phi (tw (vertex v)) *' val h (q (fst v), q (snd v)) == phi (dot h (vertex v))).
    { unfold val. cbn [fst snd]. rewrite phi_dot, Ex, Ey. ring. }
    rewrite E. now apply phi_pos.
  Qed.
  Lemma ray_holds h r : 0 <= dot h (ray r) -> nonneg (phi (tx h) *' q (fst r) +' phi (ty h) *' q (snd r)).
  Proof.
    intros H. destruct (ray_is r) as (s & Hs & Ex & Ey). apply (cancel_nonneg _ _ Hs).
    assert (E : phi s *' (phi (tx h) *' q (fst r) +' phi (ty h) *' q (snd r)) == phi (dot h (ray r))).
    { rewrite phi_dot, ray_zero, Ex, Ey, phi0. ring. }
    rewrite E. now apply phi_pos.
  Qed.
  Lemma hull_holds h vs p : (forall g, In g (map vertex vs) -> 0 <= dot h g) -> hull vs p -> holds h p.
  Proof.
    intros H (a & b & c & Ia & Ib & Ic & l & m & n & L & M & N & E & Ex & Ey).
    assert (V : forall v, In v vs -> holds h (q (fst v), q (snd v))) by (intros; apply vertex_holds, H; now apply in_map).
    pose proof (V a Ia) as Va. pose proof (V b Ib) as Vb. pose proof (V c Ic) as Vc. unfold holds in *.
    assert (val h p == l *' val h (q (fst a), q (snd a)) +' m *' val h (q (fst b), q (snd b)) +' n *' val h (q (fst c), q (snd c))) as ->.
    { unfold val. cbn [fst snd]. transitivity (phi (tx h) *' fst p +' phi (ty h) *' snd p +' phi (tw h) *' one); [ring |].
      rewrite <- E, Ex, Ey. ring. }
    auto 10.
  Qed.
  Lemma cone_along h rs r : (forall g, In g (map ray rs) -> 0 <= dot h g) -> cone rs r -> nonneg (phi (tx h) *' fst r +' phi (ty h) *' snd r).
  Proof.
    intros H (a & b & c & Ia & Ib & Ic & l & m & n & L & M & N & Ex & Ey).
    assert (V : forall v, In v rs -> nonneg (phi (tx h) *' q (fst v) +' phi (ty h) *' q (snd v))) by (intros; apply ray_holds, H; now apply in_map).
    pose proof (V a Ia) as Va. pose proof (V b Ib) as Vb. pose proof (V c Ic) as Vc.
    assert (phi (tx h) *' fst r +' phi (ty h) *' snd r == l *' (phi (tx h) *' q (fst a) +' phi (ty h) *' q (snd a)) +'
      m *' (phi (tx h) *' q (fst b) +' phi (ty h) *' q (snd b)) +' n *' (phi (tx h) *' q (fst c) +' phi (ty h) *' q (snd c))) as ->.
    { rewrite Ex, Ey. ring. }
    auto 10.
  Qed.

  Theorem bounded_sound forms cert vs : check forms cert vs [] = true -> forall p, feasible forms p <-> hull vs p.
  Proof.
    intros H p. apply generators_sound in H. destruct H as [H Hdot]. cbn [map] in *. rewrite app_nil_r in *. split.
    - intros Hp. apply mixed_hull, H, Hp.
    - intros Hp. apply feasible_halves. intros h Hh. apply (hull_holds h vs); auto.
  Qed.
  Theorem unbounded_sound forms cert vs r rs : check forms cert vs (r :: rs) = true ->
    forall p, feasible forms p <-> hull_and_cone vs (r :: rs) p.
  Proof.
    intros H p. assert (exists v, In v vs) as (v0 & Hv0).
    { destruct vs as [| v vs]; [destruct cert; discriminate | exists v; now left]. }
    apply generators_sound in H. destruct H as [H Hdot]. split.
    - intros Hp. apply (mixed_hull_and_cone vs (r :: rs) v0 r); auto; [now left |]. apply H, Hp.
    - intros (v & d & Hv & Hd & Ex & Ey). apply feasible_halves. intros h Hh. unfold holds.
      assert (val h p == val h v +' (phi (tx h) *' fst d +' phi (ty h) *' snd d)) as -> by (unfold val; rewrite Ex, Ey; ring).
      apply nonneg_add.
      + apply (hull_holds h vs v); [| assumption]. intros. apply Hdot; [assumption |]. apply in_or_app. auto.
      + apply (cone_along h (r :: rs)); [| assumption]. intros. apply Hdot; [assumption |]. apply in_or_app. auto.
  Qed.

  (* An empty set. *)
  Lemma wrong_false h p : tx h = 0 -> ty h = 0 -> tw h < 0 -> holds h p -> False.
  Proof.
    intros Hx Hy Hw H. apply (of_distinct _ _ _ _ _ _ _ _ _ _ _ field).
    unfold holds, val in H. rewrite Hx, Hy, phi0 in H.
    assert (E : phi (tw h) == zero).
    { apply antisym.
      - assert (phi (tw h) == zero *' fst p +' zero *' snd p +' phi (tw h)) as -> by ring. exact H.
      - rewrite <- phi_opp. apply phi_pos. lia. }
    destruct (inverse (- tw h)) as (i & _ & Ei); [lia |]. rewrite <- Ei, phi_opp, E. ring.
  Qed.
  Theorem empty_sound forms numbers : check_empty forms numbers = true -> forall p, ~ feasible forms p.
  Proof.
    intros H p Hp. unfold check_empty in H. rewrite feasible_halves in Hp.
    pose proof (side_holds _ p Hp) as S. set (t := table _ _ _) in *.
    unfold contradict in H. destruct numbers as [| i [| j [| k [|]]]]; cbn [map] in H; try discriminate; split_checks.
    - apply (wrong_false _ p H); auto.
    - eapply wrong_false; [| | | apply (holds_plus (times (size (side t j)) (side t i)) (times (size (side t i)) (side t j)) p)]; eauto;
        apply holds_times; auto; unfold size; lia.
    - eapply wrong_false; [| | | apply (holds_plus (times (turn (side t j) (side t k)) (side t i))
        (plus (times (turn (side t k) (side t i)) (side t j)) (times (turn (side t i) (side t j)) (side t k))) p)]; eauto.
      + apply holds_times; auto.
      + apply holds_plus; apply holds_times; auto.
  Qed.

  (* Sums of fractions, and readings. *)
  Lemma sum_is a b : q (sum a b) == q a +' q b.
  Proof.
    destruct a as [an ad], b as [bn bd]. unfold sum.
    pose proof (q_is an ad) as Ha. pose proof (q_is bn bd) as Hb.
    destruct (ad =? bd)%positive eqn:E.
    - apply Pos.eqb_eq in E. subst bd. apply (cancel_eq (Zpos ad)); [reflexivity |].
      transitivity (q (an + bn # ad) *' phi (Zpos ad)); [ring |]. rewrite q_is, phi_plus, <- Ha, <- Hb. ring.
    - apply (cancel_eq (Zpos (ad * bd))); [reflexivity |].
      transitivity (q (an * Zpos bd + bn * Zpos ad # ad * bd) *' phi (Zpos (ad * bd))); [ring |].
      rewrite q_is, Pos2Z.inj_mul, phi_plus, !phi_times, <- Ha, <- Hb. ring.
  Qed.
  Lemma minus_is b : q (- b)%Q == neg (q b).
  Proof.
    destruct b as [bn bd]. pose proof (q_is bn bd) as Hb. change (- (bn # bd))%Q with (- bn # bd)%Q.
    apply (cancel_eq (Zpos bd)); [reflexivity |].
    transitivity (q (- bn # bd) *' phi (Zpos bd)); [ring |]. rewrite q_is, phi_opp, <- Hb. ring.
  Qed.
  Lemma around_is u v y e p : meets (around u v y e) p <->
    le (neg (q e)) (sub (q y) (value (q u) (q v) p)) /\ le (sub (q y) (value (q u) (q v) p)) (q e).
  Proof.
    unfold meets, around, le. cbn [low high first second]. split.
    - intros [L H]. specialize (L _ eq_refl). specialize (H _ eq_refl). rewrite sum_is, minus_is in L. rewrite sum_is in H. split.
      + assert (sub (sub (q y) (value (q u) (q v) p)) (neg (q e)) == sub (q y +' q e) (value (q u) (q v) p)) as -> by ring. exact H.
      + assert (sub (q e) (sub (q y) (value (q u) (q v) p)) == sub (value (q u) (q v) p) (q y +' neg (q e))) as -> by ring. exact L.
    - intros [L H]. split; intros b E; injection E as <-; rewrite sum_is, ?minus_is.
      + assert (sub (value (q u) (q v) p) (q y +' neg (q e)) == sub (q e) (sub (q y) (value (q u) (q v) p))) as -> by ring. exact H.
      + assert (sub (q y +' q e) (value (q u) (q v) p) == sub (sub (q y) (value (q u) (q v) p)) (neg (q e))) as -> by ring. exact L.
  Qed.
End Soundness.
