(* Parts of the rows: which of them something meets. Rows are numbered from 1, as they stand. *)
From Coq Require Import ZArith QArith Qabs Rbase Rbasic_fun Qreals List Lia Permutation.
From Boundfit Require Import Reader Checker Convex Sound Rationals RealNumbers.
Import ListNotations.
Local Open Scope Q_scope.

Fixpoint numbered_from (i : Z) (l : list row) : list (Z * row) :=
  match l with [] => [] | r :: l => (i, r) :: numbered_from (Z.succ i) l end.
Definition numbered (l : list row) := numbered_from 1 l.

Definition mem (i : Z) (l : list Z) := existsb (Z.eqb i) l.
Lemma mem_is i l : mem i l = true <-> In i l.
Proof.
  unfold mem. rewrite existsb_exists. split.
  - intros (j & H & E). apply Z.eqb_eq in E. now subst.
  - intros H. exists i. split; [assumption | apply Z.eqb_refl].
Qed.
Fixpoint distinct (l : list Z) := match l with [] => true | i :: l => negb (mem i l) && distinct l end.
Lemma distinct_is l : distinct l = true -> NoDup l.
Proof.
  induction l as [| i l IH]; cbn; intros H; constructor; apply andb_prop in H; destruct H as [H D]; auto.
  intros I. apply mem_is in I. rewrite I in H. discriminate.
Qed.
Fixpoint insert (i : Z) (l : list Z) : list Z :=
  match l with [] => [i] | j :: l' => if (i <? j)%Z then i :: l else j :: insert i l' end.
Lemma insert_is i l : Permutation (i :: l) (insert i l).
Proof.
  induction l as [| j l IH]; cbn; [reflexivity |]. destruct (i <? j)%Z; [reflexivity |].
  rewrite perm_swap. now constructor.
Qed.
Definition equal (l l' : list Z) := if list_eq_dec Z.eq_dec l l' then true else false.

(* A point keeps a row. *)
Definition keeps_b (c : form) (v : Q * Q) :=
  let u := fst v * first c + snd v * second c in
  match low c with Some b => Qle_bool b u | None => true end && match high c with Some b => Qle_bool u b | None => true end.
Lemma keeps_b_is c v : keeps_b c v = true <-> keeps c v.
Proof.
  unfold keeps_b, keeps, at_least, at_most. rewrite Bool.andb_true_iff.
  destruct (low c), (high c); rewrite ?Qle_bool_iff; tauto.
Qed.

(* Numbers of rows that contradict each other with the conditions, and their half-planes by numbers among these. *)
Definition contradiction := (list Z * list Z)%type.

(* [P] are the points, [meets] is what the checker's rows say of them, and [at_point] takes a point of a file. *)
Section Parts.
  Variables (P : Type) (meets : form -> P -> Prop) (set : list (Q * Q) -> list (Q * Q) -> P -> Prop) (at_point : Q * Q -> P).
  Hypothesis nothing : forall forms numbers, check_empty forms numbers = true -> forall p, ~ (forall c, In c forms -> meets c p).
  Hypothesis set_is : forall forms cert vs rs, check forms cert vs rs = true -> forall p, (forall c, In c forms -> meets c p) <-> set vs rs p.
  Hypothesis meets_point : forall c v, meets c (at_point v) <-> keeps_b c v = true.
  Variables (rows : list row) (of_row : row -> form) (conditions : list form).

  Definition meets_part (part : Z -> row -> Prop) (p : P) :=
    (forall i r, In (i, r) (numbered rows) -> part i r -> meets (of_row r) p) /\ (forall c, In c conditions -> meets c p).
  Definition pick (test : Z -> row -> bool) : list form :=
    map (fun n => of_row (snd n)) (filter (fun n => test (fst n) (snd n)) (numbered rows)) ++ conditions.
  Lemma pick_is test p : (forall c, In c (pick test) -> meets c p) <-> meets_part (fun i r => test i r = true) p.
  Proof.
    unfold pick, meets_part. split.
    - intros H. split; [| intros c Hc; apply H, in_or_app; now right].
      intros i r Hr T. apply H, in_or_app. left. apply in_map_iff. exists (i, r). split; [reflexivity |].
      apply filter_In. auto.
    - intros [R C] c Hc. apply in_app_or in Hc. destruct Hc as [Hc | Hc]; [| auto].
      apply in_map_iff in Hc. destruct Hc as ((i & r) & <- & Hr). apply filter_In in Hr. cbn in *. apply R with i; tauto.
  Qed.

  Variable S : (Z -> row -> Prop) -> P -> Prop.
  Hypothesis S_is : forall part p, S part p <-> meets_part part p.
  Lemma smaller (part part' : Z -> row -> Prop) p :
    (forall i r, In (i, r) (numbered rows) -> part' i r -> part i r) -> S part p -> S part' p.
  Proof. intros H HS. apply S_is in HS. apply S_is. destruct HS as [R C]. split; [| exact C]. intros i r I T. apply (R i r I). auto. Qed.

  Definition is_left (test : Z -> row -> bool) (v : Q * Q) := forallb (fun c => keeps_b c v) (pick test).
  Lemma is_left_sound test v : is_left test v = true -> S (fun i r => test i r = true) (at_point v).
  Proof. unfold is_left. rewrite forallb_forall. intros H. apply S_is, pick_is. intros c Hc. apply meets_point. auto. Qed.

  Definition excludes (c : contradiction) := check_empty (pick (fun i _ => mem i (fst c))) (snd c).
  Lemma excludes_sound c (part : Z -> row -> Prop) p : excludes c = true ->
    (forall i r, In (i, r) (numbered rows) -> In i (fst c) -> part i r) -> ~ S part p.
  Proof.
    intros H A HS. apply (nothing _ _ H p), pick_is, S_is. apply smaller with part; [| exact HS].
    intros i r Hr M. apply (A i r Hr), mem_is, M.
  Qed.

  (* Rows that are left out: each entry has rows that are out, and a contradiction of others, one of which has to be out, too. *)
  Section Outliers.
    Variables (most : nat) (sets : list (list Z)) (entries : list (list Z * contradiction)).
    Definition known (l : list Z) :=
      existsb (fun s => forallb (fun i => mem i l) s) sets || existsb (fun e => equal l (fst e)) entries.
    Definition check_entry (e : list Z * contradiction) :=
      let rest := fst (snd e) in
      excludes (snd e) && forallb (fun i => negb (mem i (fst e))) rest &&
      (Nat.leb most (length (fst e)) || forallb (fun i => known (insert i (fst e))) rest).
    Definition check_outliers := known [] && forallb check_entry entries.

    Lemma way entry_ok : forallb check_entry entries = entry_ok -> entry_ok = true -> forall n l out p,
      (most < n + length l)%nat -> known l = true -> NoDup l -> incl l out -> (length out <= most)%nat ->
      S (fun i _ => ~ In i out) p -> exists s, In s sets /\ incl s out.
    Proof.
      intros <- All. rewrite forallb_forall in All.
      induction n as [| n IH]; intros l out p Hn K D I L HS.
      { pose proof (NoDup_incl_length D I). lia. }
      unfold known in K. apply Bool.orb_prop in K. destruct K as [K | K]; apply existsb_exists in K.
      { destruct K as (s & Is & K). exists s. split; [exact Is |]. intros i Hi. rewrite forallb_forall in K. apply I, mem_is, K, Hi. }
      destruct K as ([l' c] & Ie & K). unfold equal in K. cbn [fst] in K.
      destruct (list_eq_dec Z.eq_dec l l') as [<- |]; [| discriminate].
      apply All in Ie. unfold check_entry in Ie. cbn [fst snd] in Ie. apply andb_prop in Ie. destruct Ie as [Ie Next].
      apply andb_prop in Ie. destruct Ie as [Ex Apart]. rewrite forallb_forall in Apart.
      destruct (existsb (fun i => mem i out) (fst c)) eqn:Hit.
      - apply existsb_exists in Hit. destruct Hit as (i & Ic & Io). apply mem_is in Io.
        assert (~ In i l) by (intros Il; apply mem_is in Il; specialize (Apart i Ic); rewrite Il in Apart; discriminate).
        assert (D' : NoDup (insert i l)) by (apply (Permutation_NoDup (insert_is i l)); now constructor).
        assert (I' : incl (insert i l) out).
        { intros j Hj. apply (Permutation_in _ (Permutation_sym (insert_is i l))) in Hj. destruct Hj as [<- | Hj]; auto. }
        assert (Len : length (insert i l) = Datatypes.S (length l)) by (rewrite <- (Permutation_length (insert_is i l)); reflexivity).
        pose proof (NoDup_incl_length D' I') as M. rewrite Len in M.
        apply Bool.orb_prop in Next. destruct Next as [Next | Next]; [apply Nat.leb_le in Next; lia |].
        rewrite forallb_forall in Next. apply (IH (insert i l) out p); auto. lia.
      - exfalso. apply (excludes_sound c (fun i _ => ~ In i out) p Ex); [| exact HS].
        intros i r _ Ic Io. apply mem_is in Io.
        assert (existsb (fun i => mem i out) (fst c) = true) as E by (apply existsb_exists; eauto). congruence.
    Qed.
    Theorem outliers_sound : check_outliers = true ->
      forall out, (length out <= most)%nat -> (exists p, S (fun i _ => ~ In i out) p) -> exists s, In s sets /\ incl s out.
    Proof.
      intros H out L (p & HS). apply andb_prop in H. destruct H as [K A].
      apply (way _ eq_refl A (Datatypes.S most) [] out p); auto; [cbn; lia | constructor | intros i []].
    Qed.
  End Outliers.
  Theorem least_outliers least entries : check_outliers least [] entries = true ->
    forall out, (exists p, S (fun i _ => ~ In i out) p) -> (Datatypes.S least <= length out)%nat.
  Proof.
    intros H out HS. destruct (Nat.leb (length out) least) eqn:L.
    - apply Nat.leb_le in L. destruct (outliers_sound least [] entries H out L HS) as (s & [] & _).
    - apply Nat.leb_gt in L. lia.
  Qed.
  (* A set of so many rows, and a point that is left without them. *)
  Definition check_set (most : nat) (own : list Z * (Q * Q)) :=
    Nat.eqb (length (fst own)) most && distinct (fst own) && is_left (fun i _ => negb (mem i (fst own))) (snd own).
  Theorem sets_sound most own : forallb (check_set most) own = true ->
    forall s, In s (map fst own) -> length s = most /\ NoDup s /\ exists p, S (fun i _ => ~ In i s) p.
  Proof.
    rewrite forallb_forall. intros H s Hs. apply in_map_iff in Hs. destruct Hs as ((s' & v) & <- & Hs).
    apply H in Hs. unfold check_set in Hs. cbn [fst snd] in *. apply andb_prop in Hs. destruct Hs as [Hs L].
    apply andb_prop in Hs. destruct Hs as [N D]. split; [now apply Nat.eqb_eq |]. split; [now apply distinct_is |].
    exists (at_point v). apply is_left_sound in L. revert L. apply smaller. intros i r _ O.
    apply Bool.negb_true_iff. destruct (mem i s') eqn:M; [| reflexivity]. apply mem_is in M. contradiction.
  Qed.

  (* Runs of rows by a key, which is x or their number. *)
  Section Range.
    Variables (key : Z -> row -> Q).
    Definition spans (a b : Q) (i : Z) (r : row) := a <= key i r /\ key i r <= b.
    Definition spans_b (a b : Q) (i : Z) (r : row) := Qle_bool a (key i r) && Qle_bool (key i r) b.
    Lemma spans_is a b i r : spans_b a b i r = true <-> spans a b i r.
    Proof. unfold spans_b, spans. rewrite Bool.andb_true_iff, !Qle_bool_iff. reflexivity. Qed.
    Definition keys (members : list Z) : list Q :=
      map (fun n => key (fst n) (snd n)) (filter (fun n => mem (fst n) members) (numbered rows)).
    Lemma keys_are test members : forallb test (keys members) = true ->
      forall i r, In (i, r) (numbered rows) -> In i members -> test (key i r) = true.
    Proof.
      unfold keys. rewrite forallb_forall. intros H i r Hr M. apply H, (in_map (fun n => key (fst n) (snd n)) _ (i, r)), filter_In.
      split; [exact Hr | now apply mem_is].
    Qed.
    (* After a run comes a contradiction that begins not before the row in question, and ends where the run does not go on. Its
       keys are computed once. *)
    Definition after_run := ((Q * Q) * option contradiction)%type.
    Definition keyed (s : after_run) := (s, match snd s with Some c => keys (fst c) | None => [] end).
    Definition check_after (s : after_run * list Q) :=
      let '(((_, b), o), ks) := s in
      match o with
      | None => forallb (fun n => Qle_bool (key (fst n) (snd n)) b) (numbered rows)
      | Some c => excludes c &&
        forallb (fun n => let k := key (fst n) (snd n) in Qle_bool k b || forallb (fun q => Qle_bool q k) ks) (numbered rows)
      end.
    Definition begins (m : Q) (s : after_run * list Q) :=
      let '(((a, _), _), ks) := s in Qle_bool a m && forallb (fun q => Qle_bool m q) ks.
    Definition lonely (m : Q) (ks : list Q) := forallb (fun q => Qeq_bool q m) ks.
    Variables (runs : list (Q * Q)) (nexts : list (option contradiction)) (alones : list contradiction).
    Definition check_range :=
      let steps := map keyed (combine runs nexts) in
      let solo := map (fun c => keys (fst c)) alones in
      forallb check_after steps && forallb excludes alones &&
      forallb (fun n => let m := key (fst n) (snd n) in existsb (begins m) steps || existsb (lonely m) solo) (numbered rows).

    Lemma first_one (l : list (Z * row)) : l <> [] -> exists n, In n l /\ forall n', In n' l -> key (fst n) (snd n) <= key (fst n') (snd n').
    Proof.
      induction l as [| n l IH]; [contradiction |]. intros _. destruct l as [| n' l].
      { exists n. split; [now left |]. intros n' [<- | []]. apply Qle_refl. }
      destruct IH as (m & Im & L); [discriminate |].
      destruct (Qlt_le_dec (key (fst m) (snd m)) (key (fst n) (snd n))) as [C | C].
      - exists m. split; [now right |]. intros k [<- | Hk]; [now apply Qlt_le_weak | auto].
      - exists n. split; [now left |]. intros k [<- | Hk]; [apply Qle_refl | apply Qle_trans with (1 := C); auto].
    Qed.
    Theorem range_sound (points : list (Q * Q)) : check_range = true ->
      forallb (fun own => is_left (spans_b (fst (fst own)) (snd (fst own))) (snd own)) (combine runs points) = true ->
      length points = length runs -> forall a b, (exists i r, In (i, r) (numbered rows) /\ spans a b i r) ->
      ((exists p, S (spans a b) p) <->
       exists run, In run runs /\ forall i r, In (i, r) (numbered rows) -> spans a b i r -> spans (fst run) (snd run) i r).
    Proof.
      intros H Left Len a b (i0 & r0 & I0 & W0). unfold check_range in H.
      rewrite !Bool.andb_true_iff, !forallb_forall in H. destruct H as [[Hn Ha] Hc]. rewrite forallb_forall in Left. split.
      - intros (p & HS).
        destruct (first_one (filter (fun n => spans_b a b (fst n) (snd n)) (numbered rows))) as ([m rm] & Im & Least).
        { intros N. assert (In (i0, r0) []) as []. rewrite <- N. apply filter_In. split; [exact I0 | now apply spans_is]. }
        apply filter_In in Im. cbn [fst snd] in *. destruct Im as [Im Wm]. apply spans_is in Wm.
        assert (Late : forall i r, In (i, r) (numbered rows) -> spans a b i r -> key m rm <= key i r).
        { intros i r Hi W. apply (Least (i, r)), filter_In. split; [exact Hi | now apply spans_is]. }
        specialize (Hc (m, rm) Im). cbn [fst snd] in Hc. apply Bool.orb_prop in Hc.
        destruct Hc as [Hc | Hc]; apply existsb_exists in Hc.
        + destruct Hc as (s & Is & B). apply in_map_iff in Is. destruct Is as (((a' & b') & o) & <- & Is).
          exists (a', b'). split; [now apply in_combine_l in Is |].
          apply (in_map keyed), Hn in Is. unfold keyed in B, Is. cbn [snd] in B, Is. unfold begins in B.
          apply andb_prop in B. destruct B as [A B]. apply Qle_bool_iff in A.
          intros i r Hi W. cbn [fst snd]. unfold spans. split; [apply Qle_trans with (1 := A); now apply Late |].
          unfold check_after in Is. destruct o as [c |].
          * apply andb_prop in Is. destruct Is as [Ex Is]. rewrite forallb_forall in Is. specialize (Is (i, r) Hi). cbn [fst snd] in Is.
            apply Bool.orb_prop in Is. destruct Is as [Is | Is]; [now apply Qle_bool_iff |].
            exfalso. apply (excludes_sound c (spans a b) p Ex); [| exact HS]. intros j rj Hj Mj.
            pose proof (keys_are _ _ B j rj Hj Mj) as B'. pose proof (keys_are _ _ Is j rj Hj Mj) as B''.
            cbv beta in B', B''. apply Qle_bool_iff in B'. apply Qle_bool_iff in B''. split.
            { apply Qle_trans with (2 := B'). apply Wm. } { apply Qle_trans with (1 := B''). apply W. }
          * rewrite forallb_forall in Is. specialize (Is (i, r) Hi). now apply Qle_bool_iff.
        + destruct Hc as (ks & Ic & Al). apply in_map_iff in Ic. destruct Ic as (c & <- & Ic).
          exfalso. apply (excludes_sound c (spans a b) p (Ha c Ic)); [| exact HS].
          intros j rj Hj Mj. pose proof (keys_are _ _ Al j rj Hj Mj) as E. cbv beta in E. apply Qeq_bool_iff in E.
          unfold spans in *. rewrite E. exact Wm.
      - intros (run & Ir & W).
        destruct (In_nth runs run (0, 0) Ir) as (n & Hn' & En).
        assert (Ip : In (run, nth n points (0, 0)) (combine runs points)).
        { rewrite <- En, <- (combine_nth runs points n (0, 0) (0, 0)) by (symmetry; exact Len). apply nth_In. rewrite combine_length. lia. }
        apply Left in Ip. cbn [fst snd] in Ip. apply is_left_sound in Ip.
        exists (at_point (nth n points (0, 0))). revert Ip. apply smaller. intros i r Hi Wi. apply spans_is. auto.
    Qed.
  End Range.

  (* Rows without which the set is another one, each with a point that the others leave; and parts that make the whole set. *)
  Section Status.
    Variables (whole : P -> Prop) (vs rs : list (Q * Q)).
    Hypothesis whole_is : forall p, whole p <-> set vs rs p.
    Hypothesis whole_forms : forall p, whole p <-> (forall c, In c (map of_row rows ++ conditions) -> meets c p).
    Variables (bases : list (list Z * certificate)) (needed : list (Z * (Q * Q))).
    Definition check_base (b : list Z * certificate) := check (pick (fun i _ => mem i (fst b))) (snd b) vs rs.
    Lemma base_is b : check_base b = true -> forall p, S (fun i _ => In i (fst b)) p <-> whole p.
    Proof.
      intros H p. rewrite whole_is, <- (set_is _ _ _ _ H p), pick_is, <- S_is.
      split; apply smaller; intros i r _; apply mem_is.
    Qed.
    Definition check_needed (n : Z * (Q * Q)) :=
      is_left (fun i _ => negb (Z.eqb i (fst n))) (snd n) && negb (forallb (fun c => keeps_b c (snd n)) (map of_row rows ++ conditions)).
    Definition check_status :=
      forallb check_base bases && forallb check_needed needed &&
      forallb (fun n => mem (fst n) (map fst needed) || existsb (fun b => negb (mem (fst n) (fst b))) bases) (numbered rows).
    Theorem status_sound : check_status = true -> forall i r, In (i, r) (numbered rows) ->
      ((forall p, S (fun j _ => j <> i) p -> whole p) <-> ~ In i (map fst needed)).
    Proof.
      unfold check_status. rewrite !Bool.andb_true_iff, !forallb_forall. intros [[Hb Hn] Hc] i r Hi. split.
      - intros All I. apply in_map_iff in I. destruct I as ((j & v) & <- & I). apply Hn in I. unfold check_needed in I.
        cbn [fst snd] in *. apply andb_prop in I. destruct I as [L N]. apply is_left_sound in L.
        apply Bool.negb_true_iff in N. apply Bool.not_true_iff_false in N. apply N, forallb_forall. intros c Hcn.
        apply meets_point. apply (proj1 (whole_forms (at_point v))); [| exact Hcn]. apply All. revert L. apply smaller.
        intros k rk _ Nk. apply Bool.negb_true_iff, Z.eqb_neq, Nk.
      - intros N p HS. specialize (Hc (i, r) Hi). cbn [fst] in Hc. apply Bool.orb_prop in Hc. destruct Hc as [M | M].
        { apply mem_is in M. contradiction. }
        apply existsb_exists in M. destruct M as (b & Ib & M). apply (base_is b (Hb b Ib)). revert HS. apply smaller.
        intros j rj _ Hj E. subst. apply mem_is in Hj. rewrite Hj in M. discriminate.
    Qed.
  End Status.

  (* Rows without which something is left, each with a point; and contradictions of others. *)
  Definition check_mended (mended : list (Z * (Q * Q))) (against : list contradiction) :=
    forallb (fun n => is_left (fun i _ => negb (Z.eqb i (fst n))) (snd n)) mended && forallb excludes against &&
    forallb (fun n => mem (fst n) (map fst mended) || existsb (fun c => negb (mem (fst n) (fst c))) against) (numbered rows).
  Theorem mended_sound mended against : check_mended mended against = true -> forall i r, In (i, r) (numbered rows) ->
    ((exists p, S (fun j _ => j <> i) p) <-> In i (map fst mended)).
  Proof.
    unfold check_mended. rewrite !Bool.andb_true_iff, !forallb_forall. intros [[Hm Ha] Hc] i r Hi. split.
    - intros (p & HS). specialize (Hc (i, r) Hi). cbn [fst] in Hc. apply Bool.orb_prop in Hc.
      destruct Hc as [M | M]; [now apply mem_is |]. exfalso. apply existsb_exists in M. destruct M as (c & Ic & M).
      apply (excludes_sound c (fun j _ => j <> i) p (Ha c Ic)); [| exact HS]. intros j rj _ Hj E. subst.
      apply mem_is in Hj. rewrite Hj in M. discriminate.
    - intros I. apply in_map_iff in I. destruct I as ((j & v) & <- & I). apply Hm in I. cbn [fst snd] in *.
      exists (at_point v). apply is_left_sound in I. revert I. apply smaller. intros k rk _ N.
      apply Bool.negb_true_iff, Z.eqb_neq, N.
  Qed.
End Parts.

Section Says.
  Variables (point : Type) (meets keeps_as : form -> point -> Prop).
  Hypothesis keeps_as_is : forall c p, keeps_as c p <-> meets c p.
  Variables (rows : list row) (says : row -> point -> Prop) (of_row : row -> form) (part : Z -> row -> Prop) (p : point).
  Hypothesis says_is : forall r, says r p <-> meets (of_row r) p.
  Lemma part_says_alone :
    (forall i r, In (i, r) (numbered rows) -> part i r -> says r p) <-> meets_part point meets rows of_row [] part p.
  Proof.
    unfold meets_part. split.
    - intros K. split; [intros; apply says_is; eauto | intros c []].
    - intros [K _] i r I T. apply says_is. eauto.
  Qed.
  Lemma part_says conditions :
    ((forall i r, In (i, r) (numbered rows) -> part i r -> says r p) /\ (forall c, In c conditions -> keeps_as c p))
    <-> meets_part point meets rows of_row conditions part p.
  Proof.
    unfold meets_part. split; intros [R C]; split; intros.
    - apply says_is. eauto. - apply keeps_as_is. auto. - apply says_is. eauto. - apply keeps_as_is. auto.
  Qed.
End Says.

(* Over the rational numbers. *)
Lemma point_meets_q c v : meets_q c v <-> keeps_b c v = true.
Proof. rewrite keeps_b_is. symmetry. apply keeps_is. Qed.
Definition part_alone := part_says_alone (Q * Q) meets_q.
Definition part_is rows says of_row conditions part p H :=
  part_says (Q * Q) meets_q keeps keeps_is rows says of_row part p H conditions.

(* Over the real numbers. *)
Definition real_point (v : Q * Q) : R * R := (Q2R (fst v), Q2R (snd v)).
Lemma point_meets_r c v : meets_r c (real_point v) <-> keeps_b c v = true.
Proof.
  rewrite keeps_b_is, <- keepsR_is. unfold keepsR, keeps, real_point, at_leastR, at_mostR, at_least, at_most. cbn [fst snd].
  rewrite <- !Q2R_mult, <- Q2R_plus.
  assert (E : forall a b, (Q2R a <= Q2R b)%R <-> a <= b) by (intros; split; [apply Rle_Qle | apply Qle_Rle]).
  destruct (low c), (high c); rewrite ?E; tauto.
Qed.
Definition part_aloneR := part_says_alone (R * R) meets_r.
Definition part_isR rows says of_row conditions part p H :=
  part_says (R * R) meets_r keepsR keepsR_is rows says of_row part p H conditions.
